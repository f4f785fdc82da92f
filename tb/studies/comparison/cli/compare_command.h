// cosim compare.
#pragma once

#include "tb/cli/command.h"

namespace cosim::cli {

void add_compare(const Command& program);

}  // namespace cosim::cli
