#include "tb/program/registry.h"
#include "tb/studies/comparison/cli/compare_command.h"

namespace cosim::comparison {

void add_to(cli::Registry& registry);

void add_to(cli::Registry& registry) { registry.command(cli::add_compare); }

}  // namespace cosim::comparison
