// cosim line.
#pragma once

#include "tb/program/command.h"

namespace cosim::cli {

void add_line(const Command& program);

}  // namespace cosim::cli
