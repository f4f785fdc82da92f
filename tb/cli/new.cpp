// cosim new: a project around a design of one's own.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "model/core/input_error.h"
#include "tb/cli/commands.h"
#include "tb/cli/found.h"
#include "tb/support/draft.h"
#include "tb/support/read_file.h"
#include "tb/support/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

struct NewOptions {
  std::vector<std::string> words;  ///< the name, then the files
};

// What a project has where no RTL is given.
constexpr const char* counter = R"(// Counts the clocks on which `en` is set.
module NAME #(parameter W = 8) (
    input  wire         clk,
    input  wire         rst,
    input  wire         en,
    output wire [W-1:0] count,
    output wire         last
);
  reg [W-1:0] total;
  assign count = total;
  assign last  = &total;
  always @(posedge clk) total <= rst ? {W{1'b0}} : total + {{W-1{1'b0}}, en};
endmodule
)";
constexpr const char* counter_step = R"(  step.outputs.count = s.total;
  step.outputs.last = flag<V>(s.total == V(ones(p.W)));
  step.state.total = select(is_set(in.rst), V(0), wrap(s.total + in.en, p.W));
)";

Found counter_found(const std::string& name) {
  Found found;
  found.top = name;
  found.clock = "clk";
  found.reset = "rst";
  found.inputs = {{"rst", 1, "", 0}, {"en", 1, "", 0}};
  found.outputs = {{"count", 8, "W", 0}, {"last", 1, "", 0}};
  found.registers = {{"total", 8, "W", 0}};
  found.parameters = {{"W", 8}};
  return found;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
  return text;
}

// "fifo.count" as "fifo_count".
std::string field_of(const std::string& path) {
  std::string name = path;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

std::string width_of(const FoundNet& net) {
  if (net.parameter.empty()) return std::to_string(net.width);
  if (net.more == 0) return "p." + net.parameter;
  return fmt::format("p.{} {} {}", net.parameter, net.more < 0 ? '-' : '+', std::abs(net.more));
}

std::string table(const std::string& name, const std::vector<FoundNet>& nets) {
  std::string text = fmt::format("#define {}(FIELD)", name);
  for (const FoundNet& net : nets) {
    std::string format = net.width == 1 && net.parameter.empty() ? "flag" : "bits";
    if (field_of(net.name) != net.name) format += fmt::format(".at(\"{}\")", net.name);
    text += fmt::format(" \\\n  FIELD({}, {}, {}, \"\", \"\")", field_of(net.name), width_of(net),
                        format);
  }
  return text + '\n';
}

std::string model_of(const std::string& name, const Found& f, const std::string& step) {
  const std::string table_name = upper(name);
  std::string members, pairs;
  for (const FoundParameter& p : f.parameters) {
    members += fmt::format("  int {} = {};\n", p.name, p.value);
    pairs += fmt::format("{}{{\"{}\", p.{}}}", pairs.empty() ? "" : ", ", p.name, p.name);
  }
  std::string clear;
  if (!f.reset.empty() && f.active_low) {
    clear = fmt::format(
        "  /// A clock on which nothing is asked, and one that clears every register.\n"
        "  static constexpr Inputs<Word> rest() {{ return {{.{0} = 1}}; }}\n"
        "  static constexpr Inputs<Word> clear() {{ return {{.{0} = 0}}; }}\n",
        field_of(f.reset));
  } else {
    clear = fmt::format(
        "  /// A clock that clears every register.\n"
        "  static constexpr Inputs<Word> clear() {{ return {{{}}}; }}\n",
        f.reset.empty() ? "/* the reset, such as .rst = 1 */" : "." + field_of(f.reset) + " = 1");
  }
  std::string parameters;
  if (!pairs.empty()) {
    parameters = fmt::format(
        "  static constexpr std::array<Parameter, {}> parameters(const Params& p) {{\n"
        "    return {{{{{}}}}};\n"
        "  }}\n",
        f.parameters.size(), pairs);
  }
  return fmt::format(
      "// Golden model of {0}: what every register and output is, clock by clock.\n"
      "#pragma once\n\n"
      "#include <array>\n\n"
      "#include \"model/core/design.h\"\n\n"
      "namespace cosim::{0} {{\n\n"
      "struct Params {{\n{1}}};\n\n"
      "// FIELD(name, width, format, its number in a printed source, meaning)\n"
      "{2}{3}{4}"
      "COSIM_RECORDS({5}, Params);\n\n"
      "template <class V>\n"
      "constexpr Step<V> next([[maybe_unused]] const Params& p, const State<V>& s,\n"
      "                       [[maybe_unused]] const Inputs<V>& in) {{\n"
      "  Step<V> step{{s, {{}}}};\n"
      "{6}"
      "  return step;\n"
      "}}\n\n"
      "struct Design {{\n"
      "  COSIM_DESIGN({0});\n"
      "  static constexpr const char* name = \"{0}\";\n"
      "{7}{8}"
      "}};\n\n"
      "}}  // namespace cosim::{0}\n",
      name, members, table(table_name + "_INPUTS", f.inputs),
      table(table_name + "_OUTPUTS", f.outputs), table(table_name + "_STATE", f.registers),
      table_name, step, clear, parameters);
}

std::string cmake_of(const std::string& name, const Found& f,
                     const std::vector<std::string>& sources) {
  std::string shape;
  for (const FoundParameter& p : f.parameters) {
    shape += fmt::format("{}{}={}", shape.empty() ? "" : " ", p.name, p.value);
  }
  std::string list, top, clock;
  for (const std::string& s : sources) list += ' ' + s;
  if (f.top != name) top = " TOP " + f.top;
  if (f.clock != "clk") clock = " CLOCK " + f.clock;
  return fmt::format(R"(cmake_minimum_required(VERSION 3.25)
project({0} LANGUAGES C CXX)
set(COSIM_SOURCE "" CACHE PATH "The sources of cosim, where it is not installed")
if(COSIM_SOURCE)
  add_subdirectory(${{COSIM_SOURCE}} cosim)
else()
  find_package(cosim REQUIRED)
endif()
enable_testing()
cosim_add_design({0} SOURCES{1}{2}{3} MODEL {0}.h{4})
cosim_add_program({0}_cosim)
cosim_add_tests({0}_cosim)
)",
                     name, list, top, clock,
                     shape.empty() ? "" : fmt::format(" SHAPES \"{}\"", shape));
}

std::string readme_of(const std::string& name) {
  return fmt::format(R"(# {0}

`{0}.h` is the golden model: what every register and output is, clock by clock.

    cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release && cmake --build build
    ctest --test-dir build --output-on-failure

The first needs cosim installed, or `-DCOSIM_SOURCE=` and the folder of its sources. Then
`build/{0}_cosim --help` says what else there is: the failures of a sweep shrink themselves and are
kept in `failures/`, `replay` draws them, `prove` proves that RTL and model are the same.
)",
                     name);
}

std::string ci_of() {
  return R"(# cosim is to be installed in the image.
name: ci
on: [push, pull_request]
jobs:
  test:
    runs-on: ubuntu-24.04
    container: debian:12
    steps:
      - uses: actions/checkout@v4
      - run: cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release && cmake --build build
      - run: ctest --test-dir build --output-on-failure
)";
}

int run(const NewOptions& o) {
  if (o.words.empty()) throw InputError("NAME: is needed");
  const std::string& name = o.words.front();
  const bool good =
      !name.empty() &&
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos &&
      name.front() >= 'a' && name.front() <= 'z';
  if (!good) {
    throw InputError(fmt::format("NAME: {} is not small letters, digits and _, a letter first",
                                 in_quotes(name)));
  }
  if (fs::exists(name)) throw InputError(name + ": exists");
  const std::vector<std::string> files(o.words.begin() + 1, o.words.end());
  std::vector<std::string> texts;
  for (const std::string& f : files) texts.push_back(read_file(f));
  const Found found = files.empty() ? counter_found(name) : found_in(files);

  Draft project(fs::current_path(), name);
  std::vector<std::string> sources;
  if (files.empty()) {
    sources = {name + ".v"};
    project.write(sources.front(), replaced(counter, "NAME", name));
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    sources.push_back(fs::path(files[i]).filename().string());
    project.write(sources.back(), texts[i]);
  }
  const std::string step =
      files.empty() ? counter_step
                    : "  // To be written: step.outputs of this clock, step.state after it.\n";
  project.write(name + ".h", model_of(name, found, step));
  project.write("CMakeLists.txt", cmake_of(name, found, sources));
  project.write("README.md", readme_of(name));
  fs::create_directories(project.folder() / ".github/workflows");
  project.write(".github/workflows/ci.yml", ci_of());
  project.finish();
  fmt::print("{}/: {}, {}, {}; README.md has its two commands\n", name,
             count(found.inputs.size(), "input"), count(found.outputs.size(), "output"),
             count(found.registers.size(), "register"));
  if (!files.empty()) fmt::print("{0}/{0}.h: next() is to be written\n", name);
  if (found.reset.empty()) fmt::print("{0}/{0}.h: clear() is to name the reset\n", name);
  return 0;
}

}  // namespace

void add_new(const Command& program) {
  auto o = std::make_shared<NewOptions>();
  const Command command = program.sub("new", "A project for a design of your own, in a new folder");
  command.arguments("NAME FILE...", o->words,
                    "The folder and the design; then its Verilog, whose ports, parameters and\n"
                    "registers become the model's tables. Without a file: a counter that passes");
  command.footer("Example: cosim new adder adder.v");
  command.action([o] { return run(*o); });
}

}  // namespace cosim::cli
