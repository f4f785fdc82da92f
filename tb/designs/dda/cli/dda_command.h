// cosim dda.
#pragma once

#include "tb/cli/command.h"

namespace cosim::cli {

void add_dda(const Command& program);

}  // namespace cosim::cli
