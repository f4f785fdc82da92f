// mutants SHAPE COUNT [WORD...]: the program of tb/mutation/main_of.cpp for a shape that is built.
// mutants SHAPE COUNT --verilog FILE: writes RTL that has them.
// mutants SHAPE COUNT --draw N FOLDER: draws N of them that lanes kill, for drawn.h.
#include "tb/mutation/built.h"

#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numeric>
#include <string_view>
#include <vector>

#include "model/core/input_error.h"
#include "tb/mutation/drawn.h"
#include "tb/proof/machines.h"

namespace cosim::mutation {

std::unique_ptr<LanesSubject> built_subject(const std::string& title, unsigned count) {
  for (const auto& bench : benches()) {
    if (bench->built_as() != title) continue;
    for (const auto& machine : proof::built_machines()) {
      if (machine.title != title) continue;
      proof::Source source = machine.source;
      source.parameters = bench->parameters();
      return std::make_unique<LanesSubject>(*bench, cases_of_built(*bench), source, count);
    }
  }
  throw InputError(title + ": is not built");
}

}  // namespace cosim::mutation

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "mutants: needs a shape and a number of mutants\n");
    return 2;
  }
  try {
    const auto subject =
        cosim::mutation::built_subject(argv[1], static_cast<unsigned>(std::atoi(argv[2])));
    if (argc == 5 && std::string_view(argv[3]) == "--verilog") {
      std::vector<unsigned> all(subject->mutants().size());
      std::iota(all.begin(), all.end(), 1U);
      subject->write_verilog(all, argv[4]);
      return 0;
    }
    if (argc == 6 && std::string_view(argv[3]) == "--draw") {
      cosim::mutation::draw(*subject, static_cast<std::size_t>(std::atoi(argv[4])), argv[5]);
      return 0;
    }
    return cosim::mutation::main_of(*subject, argc - 2, argv + 2);
  } catch (const std::exception& error) {
    fmt::print(stderr, "mutants: {}\n", error.what());
    return 2;
  }
}
