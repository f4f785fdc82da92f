// The commands of the harness itself. Each adds itself to the program.
#pragma once

#include "tb/cli/command.h"

namespace cosim::cli {

class Registry;

void add_list(const Command& program);
void add_examples(const Command& program, const Registry& registry);
void add_sweep(const Command& program, const Registry& registry);
void add_replay(const Command& program);
void add_job(const Command& program);
void add_program(const Command& program);
void add_wave_command(const Command& program);
void add_cover(const Command& program, const Registry& registry);

}  // namespace cosim::cli
