// cosim arc.
#pragma once

#include "tb/cli/command.h"

namespace cosim::cli {

void add_arc(const Command& program);

}  // namespace cosim::cli
