// cosim compare.
#pragma once

#include "tb/program/command.h"

namespace cosim::cli {

void add_compare(const Command& program);

}  // namespace cosim::cli
