#include "tb/new/found_shape.h"

#include <fmt/core.h>

#include <sstream>

#include "rtl_reader.h"
#include "tb/support/output_file.h"
#include "tb/support/process.h"

namespace cosim::cli {

FoundShape shape_of(std::string_view text) {
  FoundShape shape;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
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

void write_reader(const std::filesystem::path& folder) {
  for (const ReaderFile& program : rtl_reader) {
    OutputFile file((folder / program.name).string());
    file.text(program.text);
    file.close();
  }
}

std::optional<FoundShape> shape_with(const RtlQuestion& question, const std::string& other,
                                     long value, const std::filesystem::path& reader,
                                     const std::filesystem::path& work) {
  std::filesystem::create_directories(work);
  const std::string tree = (work / "tree.xml").string();
  std::vector<std::string> words{"env",       "-C",           question.folder.string(),
                                 "verilator", "--xml-only",   "--xml-output",
                                 tree,        "--top-module", question.top,
                                 "-Mdir",     work.string(),  "-Wno-fatal",
                                 "-Wno-lint", "-Wno-style"};
  words.insert(words.end(), question.options.begin(), question.options.end());
  for (const FoundParameter& p : question.parameters) {
    if (p.name == other) continue;
    words.push_back(fmt::format("-G{}={}", p.name, p.is_text ? '"' + p.value + '"' : p.value));
  }
  words.push_back(fmt::format("-G{}={}", other, value));
  const std::string made = (work / "vhdl.v").string();
  std::vector<std::string> vhdl{
      "env",        "-C", question.folder.string(), "perl", (reader / "vhdl.pl").string(),
      question.top, made};
  for (const FoundParameter& p : question.parameters) {
    if (p.name != other) vhdl.push_back(p.name + '=' + p.value);
  }
  vhdl.push_back(fmt::format("{}={}", other, value));
  const std::size_t none = vhdl.size();
  for (const std::string& file : question.files) (is_vhdl(file) ? vhdl : words).push_back(file);
  if (vhdl.size() != none) {
    if (cosim::run_program(vhdl).status != 0) return std::nullopt;
    words.push_back(made);
  }
  if (cosim::run_program(words).status != 0) return std::nullopt;
  const Ended ended = cosim::run_program({"perl", (reader / "rtl_shape.pl").string(), tree});
  if (ended.status != 0) return std::nullopt;
  return shape_of(ended.text);
}

}  // namespace cosim::cli
