// cosim path.
#pragma once

#include "tb/program/command.h"

namespace cosim::cli {

void add_path(const Command& program);

}  // namespace cosim::cli
