// The files a command writes, looked at before it runs: a long run shall not end in an error that
// was there from its start, and no file is written over that is read or written otherwise.
#pragma once

#include <string>

#include "tb/cli/command.h"

namespace cosim::cli {

/// InputError where --csv, --report, --checkpoint, --plot or --wave names no file, where two name
/// one and the same, where one of them is the file `input` or the one that standard output goes to,
/// and where any of them but the CSV cannot be written. Leaves all files as they are. To be called
/// when all other input has proved good.
void check_outputs(const Common& common, const std::string& input = "");

}  // namespace cosim::cli
