#include "tb/program/registry.h"
#include "tb/studies/toolpath/cli/path_command.h"

namespace cosim::toolpath {

void add_to(cli::Registry& registry);

void add_to(cli::Registry& registry) {
  registry.command(cli::add_path);
  registry.example({"Toolpath: a flange, 100 steps a millimetre",
                    {"path", "tests/toolpaths/flange.ngc", "--steps-per-mm", "100"}});
}

}  // namespace cosim::toolpath
