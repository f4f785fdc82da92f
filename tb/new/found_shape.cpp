#include "tb/new/found_shape.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "model/core/input_error.h"
#include "rtl_reader.h"
#include "tb/new/new_sources.h"
#include "tb/rtl/plain_verilog.h"
#include "tb/support/output_file.h"
#include "tb/support/words.h"

namespace cosim::cli {

FoundShape shape_of(std::string_view text) {
  FoundShape shape;
  for (const std::string& line : lines_in(text)) {
    std::istringstream words(line);
    std::string what, name, way;
    words >> what;
    int width = 0, count = 0;
    if (what == "top") {
      words >> shape.top;
    } else if (what == "port") {
      words >> way >> name >> width >> count;
      shape.ports.emplace_back(way, FoundNet{name, {width}, {count}});
    } else if (what == "parameter") {
      long value = 0;
      words >> name >> value;
      shape.parameters.emplace_back(name, value);
    } else if (what == "net") {
      words >> name >> width >> count;
      shape.nets[name] = {width, count};
    }
  }
  return shape;
}

std::filesystem::path write_reader(const Scratch& scratch) {
  const std::filesystem::path folder = scratch.path() / "reader";
  std::filesystem::create_directory(folder);
  try {
    for (const ReaderFile& program : rtl_reader) {
      write_file((folder / program.name).string(), program.text);
    }
  } catch (const InputError&) {
    require_room(scratch.path());
    throw;
  }
  return folder;
}

std::string as_plain_verilog(std::vector<std::string>& files, const std::string& top,
                             const std::vector<std::string>& parameters,
                             const std::vector<std::string>& blackboxes,
                             const std::filesystem::path& folder,
                             const std::filesystem::path& reader, const std::filesystem::path& made,
                             bool has_constants) {
  const auto vhdl = std::stable_partition(files.begin(), files.end(),
                                          [](const std::string& file) { return !is_vhdl(file); });
  const auto run = [&](const std::string& program, std::vector<std::string> words) {
    words.insert(words.begin(),
                 {"env", "-C", folder.string(), "perl", (reader / program).string(), top});
    return cosim::run_program(words);
  };
  if (vhdl != files.end()) {
    std::vector<std::string> words{made.string()};
    words.insert(words.end(), parameters.begin(), parameters.end());
    words.insert(words.end(), vhdl, files.end());
    const Ended ended = run("vhdl.pl", words);
    if (ended.status != 0) return ended.text.substr(0, ended.text.find('\n'));
    files.erase(vhdl, files.end());
    files.push_back(made.string());
  }
  try {
    files = rtl::plain_verilog({folder, files, top, parameters, blackboxes, has_constants},
                               made.parent_path() / made.stem());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::optional<FoundShape> shape_with(const RtlQuestion& question, const std::string& other,
                                     long value, const RtlReader& reader,
                                     const std::filesystem::path& work) {
  std::filesystem::create_directories(work);
  const std::string tree = (work / "tree.xml").string();
  std::vector<std::string> words{"env", "-C", question.folder.string(), reader.verilator};
  words.insert(words.end(), {"--top-module", question.top, "-Mdir", work.string()});
  words.insert(words.end(), {"--xml-only", "--xml-output", tree, "--no-timing"});
  words.insert(words.end(), {"-Wno-fatal", "-Wno-lint", "-Wno-style"});
  words.insert(words.end(), question.options.begin(), question.options.end());
  for (const FoundParameter& p : question.parameters) {
    if (p.name == other) continue;
    words.push_back(fmt::format("-G{}={}", p.name, p.is_text ? '"' + p.value + '"' : p.value));
  }
  words.push_back(fmt::format("-G{}={}", other, value));
  std::vector<std::string> files = question.files, parameters{fmt::format("{}={}", other, value)};
  for (const FoundParameter& p : question.parameters) {
    if (p.name != other) parameters.push_back(p.name + '=' + p.value);
  }
  const std::string wrong =
      as_plain_verilog(files, question.top, parameters, question.blackboxes, question.folder,
                       reader.folder, work / "vhdl.v", false);
  if (!wrong.empty()) return std::nullopt;
  words.insert(words.end(), files.begin(), files.end());
  if (cosim::run_program(words).status != 0) return std::nullopt;
  const Ended ended = cosim::run_program({"perl", (reader.folder / "rtl_shape.pl").string(), tree});
  if (ended.status != 0) return std::nullopt;
  return shape_of(ended.text);
}

}  // namespace cosim::cli
