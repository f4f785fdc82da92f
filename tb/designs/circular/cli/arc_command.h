// cosim arc.
#pragma once

#include "tb/program/command.h"

namespace cosim::cli {

void add_arc(const Command& program);

}  // namespace cosim::cli
