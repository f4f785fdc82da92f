// What stands around a model in the project that `cosim new` makes, and the design of one without
// RTL.
#include <fmt/core.h>

#include "first_designs.h"
#include "tb/new/new.h"
#include "tb/util/quoted.h"

namespace cosim::cli {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
  return text;
}

}  // namespace

FirstDesign first_design(const std::string& name, NewModel model) {
  const bool streams = model == NewModel::stream;
  const std::string was = streams ? "fir" : "counter";
  const auto named = [&](const std::string& text) {
    const std::string again = replaced(replaced(text, was, name), upper(was), upper(name));
    return replaced(again, in_one_word(was), in_one_word(name));
  };
  const std::string call = name + " SOURCES " + name + ".v MODEL " + name + ".h SHAPES ";
  if (streams) {
    return {"a filter", named(fir_rtl), named(fir_model),
            call + "\"W=8 STAGES=1\" \"W=12 STAGES=3\""};
  }
  return {"a counter", named(counter_rtl), named(counter_model),
          call + "\"W=8\"" + (model == NewModel::unproved ? " UNPROVED" : "")};
}

std::string design_of(const std::string& name, const Found& f,
                      const std::vector<std::string>& sources, NewModel model,
                      const std::string& headers, const std::vector<std::string>& defines,
                      const std::vector<std::string>& blackboxes) {
  std::string text = name + " SOURCES";
  for (const std::string& s : sources) text += ' ' + for_cmake(s);
  if (f.top != name) text += " TOP " + for_cmake(f.top);
  if (!headers.empty()) text += " INCLUDE_DIRS " + headers;
  if (!blackboxes.empty()) {
    text += " BLACKBOXES";
    for (const std::string& box : blackboxes) text += ' ' + for_cmake(box);
  }
  if (!defines.empty()) {
    text += " DEFINES";
    for (const std::string& d : defines) text += ' ' + for_cmake(d);
  }
  if (f.clocks.empty()) {
    text += " COMBINATIONAL";
  } else if (f.clocks_are_inputs() || f.clocks.front().name != "clk") {
    text += f.clocks_are_inputs() ? " CLOCKS" : " CLOCK";
    for (const FoundClock& clock : f.clocks) text += ' ' + for_cmake(clock.name);
  }
  text += fmt::format(" MODEL {}.h", name);
  const std::string type = struct_of(name, f);
  if (type != in_one_word(name)) text += " STRUCT " + type;
  std::string shape;
  for (const FoundParameter& p : f.parameters) {
    shape += fmt::format("{}{}={}", shape.empty() ? "" : " ", p.name, p.value);
  }
  if (!shape.empty()) text += fmt::format(" SHAPES \"{}\"", shape);
  const bool is_proved = model == NewModel::proved && f.unread.empty() && !f.has_inner_reset();
  return is_proved || model == NewModel::stream ? text : text + " UNPROVED";
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

std::string readme_of(const std::string& name, NewModel model) {
  return fmt::format(
      R"(# {0}

`{0}.h` is the golden model: {2}.

    cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release && cmake --build build
    ctest --test-dir build --output-on-failure

The first command needs cosim installed, or `-DCOSIM_SOURCE=` with the folder of its sources. A failure
is shrunk and kept in `failures/`, one of ctest in `build/failures/`; `build/{0}_cosim wave` opens the newest
one in GTKWave, `build/{0}_cosim wave build/failures/NAME` that one{1}.
`build/{0}_cosim --help` lists all commands.
)",
      name,
      model == NewModel::proved ? ", and `prove`\nproves that RTL and model are the same" : "",
      model == NewModel::stream ? "what comes out of the streams for what goes in"
                                : "what every register and output is, clock by clock");
}

std::string ci_of() {
  return R"(# cosim must be installed in the image.
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

}  // namespace cosim::cli
