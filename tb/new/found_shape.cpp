#include "tb/new/found_shape.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include "model/core/input_error.h"
#include "rtl_reader.h"
#include "tb/rtl/plain_verilog.h"
#include "tb/util/output_file.h"
#include "tb/util/words.h"

namespace cosim::cli {

std::filesystem::path write_reader(const Scratch& scratch) {
  const std::filesystem::path folder = scratch.path() / "reader";
  try {
    for (const ReaderFile& script : rtl_reader) {
      std::filesystem::create_directories((folder / script.name).parent_path());
      write_file((folder / script.name).string(), script.text);
    }
  } catch (const InputError&) {
    require_room(scratch.path());
    throw;
  }
  return folder;
}

std::vector<std::string> plain_verilog(const RtlQuestion& question,
                                       const std::vector<std::string>& parameters,
                                       const std::filesystem::path& work) {
  return rtl::plain_verilog(
      {question.folder, question.files, question.top, parameters, question.blackboxes}, work,
      [](const auto& words) { return cosim::run_program(words).status; });
}

std::optional<rtl::Shape> shape_with(const RtlQuestion& question, const std::string& other,
                                     long value, const std::vector<std::string>& verilator,
                                     const std::filesystem::path& work) {
  std::filesystem::create_directories(work);
  const std::string tree = (work / "tree").string();
  std::vector<std::string> words{"env", "-C", question.folder.string()};
  words.insert(words.end(), verilator.begin(), verilator.end());
  words.insert(words.end(), {tree, "--top-module", question.top, "-Mdir", work.string()});
  words.insert(words.end(), {"--no-timing", "-Wno-fatal", "-Wno-lint", "-Wno-style"});
  words.insert(words.end(), question.options.begin(), question.options.end());
  for (const FoundParameter& p : question.parameters) {
    if (p.name == other) continue;
    words.push_back(fmt::format("-G{}={}", p.name, p.is_text ? '"' + p.value + '"' : p.value));
  }
  words.push_back(fmt::format("-G{}={}", other, value));
  std::vector<std::string> parameters{fmt::format("{}={}", other, value)};
  for (const FoundParameter& p : question.parameters) {
    if (p.name != other) parameters.push_back(p.name + '=' + p.value);
  }
  try {
    const auto files = plain_verilog(question, parameters, work);
    words.insert(words.end(), files.begin(), files.end());
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (cosim::run_program(words).status != 0) return std::nullopt;
  try {
    return rtl::shape_of(tree);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace cosim::cli
