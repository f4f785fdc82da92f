#include "tb/mutation/built.h"

#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include "model/core/input_error.h"
#include "tb/mutation/drawn.h"
#include "tb/mutation/lanes_subject.h"
#include "tb/proof/machines.h"
#include "tb/support/place.h"

namespace cosim::mutation {
namespace {

// Registers that yosys would lose are named to it.
std::vector<std::string> registers_of(const AnyBench& bench) {
  std::vector<std::string> nets;
  const auto fields = bench.compared();
  for (std::size_t i = 0; i < bench.registers(); ++i) {
    const std::string net = net_path(fields[i].net).path;
    if (nets.empty() || nets.back() != net) nets.push_back(net);
  }
  return nets;
}

std::unique_ptr<LanesSubject> built_subject(Cases (*cases)(const AnyBench&),
                                            const std::string& title, unsigned count) {
  for (const auto& bench : benches()) {
    if (bench->title() != title) continue;
    for (const auto& machine : proof::built_machines()) {
      if (machine.title != title) continue;
      proof::Source source = machine.source;
      source.parameters = bench->parameters();
      source.kept = registers_of(*bench);
      return std::make_unique<LanesSubject>(*bench, cases(*bench), source, count);
    }
  }
  throw InputError(title + ": is not built");
}

}  // namespace

int main_of_built(Cases (*cases)(const AnyBench&), int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "mutants: needs a shape and a number of mutants\n");
    return 2;
  }
  try {
    const auto subject = built_subject(cases, argv[1], static_cast<unsigned>(std::atoi(argv[2])));
    if (argc == 5 && std::string_view(argv[3]) == "--verilog") {
      std::vector<unsigned> all(subject->mutants().size());
      std::iota(all.begin(), all.end(), 1U);
      subject->write_verilog(all, argv[4]);
      return 0;
    }
    if (argc == 6 && std::string_view(argv[3]) == "--draw") {
      draw(*subject, static_cast<std::size_t>(std::atoi(argv[4])), argv[5]);
      return 0;
    }
    return main_of(*subject, argc - 2, argv + 2);
  } catch (const std::exception& error) {
    fmt::print(stderr, "mutants: {}\n", error.what());
    return 2;
  }
}

}  // namespace cosim::mutation
