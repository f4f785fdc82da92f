// cosim dda.
#pragma once

#include "tb/program/command.h"

namespace cosim::cli {

void add_dda(const Command& program);

}  // namespace cosim::cli
