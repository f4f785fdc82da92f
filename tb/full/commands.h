// The commands that only the full program has. Each adds itself to the program.
#pragma once

#include "tb/cli/full.h"

namespace cosim::cli {

void add_prove(const Command& program, const Registry& registry);
void add_lint(const Command& program);
void add_mutate(const Command& program, const Registry& registry);
void add_regress(const Command& program, const Registry& registry);
void add_equiv(const Command& program);
void add_new(const Command& program);

}  // namespace cosim::cli
