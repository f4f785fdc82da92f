// cosim new: a project around a design of one's own.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "counter.h"
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
  bool plain = false;
};

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

std::string text_of(const FoundSize& size) {
  if (size.parameter.empty()) return std::to_string(size.number);
  if (size.more == 0) return "p." + size.parameter;
  return fmt::format("p.{} {} {}", size.parameter, size.more < 0 ? '-' : '+', std::abs(size.more));
}

// The widest elements of equal width, at most 64 bits, that make up a word of a memory.
int part_of(const FoundNet& memory) {
  constexpr int widest = 64;
  int part = std::min(memory.width.number, widest);
  while (memory.width.number % part != 0) --part;
  return part;
}

std::string row(const FoundNet& net) {
  const int width = net.width.number, words = net.words.number;
  std::string format = width == 1 && net.width.parameter.empty() ? "flag" : "bits";
  std::string shown = text_of(net.width);
  if (words == 0 && width > 64) {
    format += fmt::format(".words<{}>()", (width + 63) / 64);
  } else if (words != 0) {
    const int part = part_of(net);
    if (part != width) {
      shown = std::to_string(part);
      format += fmt::format(".array<{}>()", words * (width / part));
    } else {
      const bool fixed = net.words.parameter.empty();
      format += fmt::format(".array<{}>({})", words, fixed ? "" : text_of(net.words));
    }
  }
  const std::string name = field_of(net.name);
  if (name != net.name) format += fmt::format(".at(\"{}\")", net.name);
  if (!net.is_reset) format += ".unreset()";
  return fmt::format("FIELD({}, {}, {}, \"\", \"\")", name, shown, format);
}

std::string table(const std::string& name, const std::vector<FoundNet>& nets) {
  std::string text = fmt::format("#define {}(FIELD)", name);
  for (const FoundNet& net : nets) text += " \\\n  " + row(net);
  return text + '\n';
}

// The head of a model's step, up to its body.
std::string step_head(bool plain) {
  return fmt::format(
      "{0} Step<{1}> next([[maybe_unused]] const Params& p, const State<{1}>& s,\n"
      "                       [[maybe_unused]] const Inputs<{1}>& in) {{\n",
      plain ? "inline" : "template <class V>\nconstexpr", plain ? "Word" : "V");
}

// The counter's model, but its step in C++ as anyone writes it.
std::string plain_counter() {
  std::string model = counter_model;
  const std::size_t from = model.find("template <class V>\n"), to = model.find("\n}\n", from) + 3;
  return model.replace(
      from, to - from,
      R"(inline Step<Word> next(const Params& p, const State<Word>& s, const Inputs<Word>& in) {
  Step<Word> step{s, {s.total, 0}};
  if (s.total == ones(p.width)) step.outputs.last = 1;
  if (in.en != 0) step.state.total = wrap(s.total + 1, p.width);
  if (in.rst != 0) step.state.total = 0;
  return step;
}
)");
}

std::string model_of(const std::string& name, const Found& f, bool plain) {
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
  if (f.asynchronous) clear += "  static constexpr bool asynchronous_reset = true;\n";
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
      "{8}"
      "  Step<{9}> step{{s, {{}}}};\n"
      "  // To be written: step.outputs of this clock, step.state after it.\n"
      "  return step;\n"
      "}}\n\n"
      "struct Design {{\n"
      "  COSIM_DESIGN({0});\n"
      "  static constexpr const char* name = \"{0}\";\n"
      "{6}{7}"
      "}};\n\n"
      "}}  // namespace cosim::{0}\n",
      name, members, table(table_name + "_INPUTS", f.inputs),
      table(table_name + "_OUTPUTS", f.outputs), table(table_name + "_STATE", f.registers),
      table_name, clear, parameters, step_head(plain), plain ? "Word" : "V");
}

// What cosim_add_design() is told of RTL that was read.
std::string design_of(const std::string& name, const Found& f,
                      const std::vector<std::string>& sources, bool plain) {
  std::string text = name + " SOURCES";
  for (const std::string& s : sources) text += ' ' + s;
  if (f.top != name) text += " TOP " + f.top;
  if (f.clock != "clk") text += " CLOCK " + f.clock;
  text += fmt::format(" MODEL {}.h", name);
  std::string shape;
  for (const FoundParameter& p : f.parameters) {
    shape += fmt::format("{}{}={}", shape.empty() ? "" : " ", p.name, p.value);
  }
  if (!shape.empty()) text += fmt::format(" SHAPES \"{}\"", shape);
  return plain ? text + " UNPROVED" : text;
}

std::string cmake_of(const std::string& name, const std::string& design) {
  return fmt::format(R"(cmake_minimum_required(VERSION 3.25)
project({0} LANGUAGES C CXX)
set(COSIM_SOURCE "" CACHE PATH "The sources of cosim, where it is not installed")
if(COSIM_SOURCE)
  add_subdirectory(${{COSIM_SOURCE}} cosim)
else()
  find_package(cosim REQUIRED)
endif()
enable_testing()
cosim_add_design({1})
cosim_add_program({0}_cosim)
cosim_add_tests({0}_cosim)
)",
                     name, design);
}

std::string readme_of(const std::string& name, bool plain) {
  return fmt::format(R"(# {0}

`{0}.h` is the golden model: what every register and output is, clock by clock.

    cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release && cmake --build build
    ctest --test-dir build --output-on-failure

The first needs cosim installed, or `-DCOSIM_SOURCE=` and the folder of its sources. Then
`build/{0}_cosim --help` says what else there is: the failures of a sweep shrink themselves and are
kept in `failures/`, `replay` draws them{1}.
)",
                     name, plain ? "" : ", `prove` proves that RTL and model are the same");
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
  const Found found = files.empty() ? Found{} : found_in(files);

  Draft project(fs::current_path(), name);
  std::string design;
  if (files.empty()) {
    const auto named = [&](const std::string& text) {
      return replaced(replaced(text, "counter", name), "COUNTER", upper(name));
    };
    project.write(name + ".v", named(counter_rtl));
    project.write(name + ".h", named(o.plain ? plain_counter() : counter_model));
    design = fmt::format("{0} SOURCES {0}.v MODEL {0}.h SHAPES \"W=8\"{1}", name,
                         o.plain ? " UNPROVED" : "");
  } else {
    std::vector<std::string> sources;
    for (std::size_t i = 0; i < files.size(); ++i) {
      sources.push_back(fs::path(files[i]).filename().string());
      project.write(sources.back(), texts[i]);
    }
    project.write(name + ".h", model_of(name, found, o.plain));
    design = design_of(name, found, sources, o.plain);
  }
  project.write("CMakeLists.txt", cmake_of(name, design));
  project.write("README.md", readme_of(name, o.plain));
  fs::create_directories(project.folder() / ".github/workflows");
  project.write(".github/workflows/ci.yml", ci_of());
  project.finish();
  if (files.empty()) {
    fmt::print("{}/: a counter; README.md has its two commands\n", name);
    return 0;
  }
  fmt::print("{}/: {}, {}, {}; README.md has its two commands\n", name,
             count(found.inputs.size(), "input"), count(found.outputs.size(), "output"),
             count(found.registers.size(), "register"));
  fmt::print("{0}/{0}.h: next() is to be written\n", name);
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
  command.flag("--plain", o->plain,
               "The model's step in any C++, on machine integers: nothing is proved of it");
  command.footer(fmt::format("Example: {} new adder adder.v", program_name()));
  command.action([o] { return run(*o); });
}

}  // namespace cosim::cli
