// cosim line.
#pragma once

#include "tb/cli/command.h"

namespace cosim::cli {

void add_line(const Command& program);

}  // namespace cosim::cli
