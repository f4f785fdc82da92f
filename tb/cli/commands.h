// The commands of cosim. Each adds itself to the program.
#pragma once

#include "tb/cli/command.h"

namespace cosim::cli {

void add_list(const Command& program);
void add_line(const Command& program);
void add_arc(const Command& program);
void add_dda(const Command& program);
void add_path(const Command& program);
void add_compare(const Command& program);
void add_sweep(const Command& program);
void add_replay(const Command& program);
void add_prove(const Command& program);

}  // namespace cosim::cli
