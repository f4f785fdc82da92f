// The full form of a program.
#include "tb/cli/full.h"

#include <string_view>

#include "tb/full/ask_points.h"
#include "tb/full/commands.h"
#include "tb/full/in_lanes.h"
#include "tb/sim/bench.h"

namespace cosim::cli {
namespace {

void nothing(const Registry&) {}

void add_commands(const Command& program, const Registry& registry) {
  if (!benches().empty()) {  // not the program of the package
    add_prove(program, registry);
    add_mutate(program, registry);
    add_regress(program, registry);
    add_lint(program);
  }
  add_equiv(program);
  add_new(program);
}

}  // namespace
}  // namespace cosim::cli

int main(int argc, char** argv) {
  using namespace cosim::cli;
  return run_form(argc, argv, {nothing, add_commands, nothing, in_lanes, ask_points});
}
