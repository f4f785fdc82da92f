// cosim path.
#pragma once

#include "tb/cli/command.h"

namespace cosim::cli {

void add_path(const Command& program);

}  // namespace cosim::cli
