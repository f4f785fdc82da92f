// How a command ends: the report, the lines for a person, the exit status.
#pragma once

#include <string>
#include <vector>

#include "tb/cli/command.h"
#include "tb/report.h"

namespace cosim::cli {

/// Writes the report where one is asked for (`extra`: more of its keys, a JSON object), prints what
/// was compared and the verdict. 0 where all matched, else 1.
int conclude(const std::vector<Outcome>& outcomes, const Common& common,
             const std::string& extra = "{}");

}  // namespace cosim::cli
