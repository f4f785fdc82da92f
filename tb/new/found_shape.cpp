#include "tb/new/found_shape.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <sstream>

#include "model/core/input_error.h"
#include "rtl_reader.h"
#include "tb/rtl/plain_verilog.h"
#include "tb/util/output_file.h"
#include "tb/util/words.h"

namespace cosim::cli {

FoundShape shape_of(std::string_view text) {
  FoundShape shape;
  for (const std::string& line : lines_in(text)) {
    std::istringstream words(line);
    std::string what, name, way;
    words >> what;
    if (what == "top") {
      words >> shape.top;
    } else if (what == "port") {
      words >> way >> name;
      shape.ports.emplace_back(way, name);
    } else if (what == "parameter") {
      long value = 0;
      words >> name >> value;
      shape.parameters.emplace_back(name, value);
    } else if (what == "net") {
      words >> name;
      FoundShape::Net& net = shape.nets[name];
      words >> net.width >> net.words >> net.is_signed;
    } else if (what == "part") {
      FoundPart part;
      words >> name >> part.name >> part.high >> part.low >> part.is_signed >> part.type;
      if (part.name == "-") part.name.clear();
      if (part.type == "-") part.type.clear();
      shape.nets[name].parts.push_back(part);
    } else if (what == "enum") {
      words >> name;
      for (std::string value; words >> value;) shape.enums[name].push_back(value);
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

std::vector<std::string> plain_verilog(const RtlQuestion& question,
                                       const std::vector<std::string>& parameters,
                                       const std::filesystem::path& work) {
  return rtl::plain_verilog(
      {question.folder, question.files, question.top, parameters, question.blackboxes}, work,
      [](const auto& words) { return cosim::run_program(words).status; });
}

std::optional<FoundShape> shape_with(const RtlQuestion& question, const std::string& other,
                                     long value, const RtlReader& reader,
                                     const std::filesystem::path& work) {
  std::filesystem::create_directories(work);
  const std::string tree = (work / "tree").string();
  std::vector<std::string> words{"env", "-C", question.folder.string()};
  words.insert(words.end(), reader.verilator.begin(), reader.verilator.end());
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
  const Ended ended = cosim::run_program({"perl", (reader.folder / "rtl_shape.pl").string(), tree});
  if (ended.status != 0) return std::nullopt;
  return shape_of(ended.text);
}

}  // namespace cosim::cli
