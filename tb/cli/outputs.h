// The files a command writes are checked before it runs. A long run must not fail at its end for a
// reason that was there at its start, and no file may be written twice, or read and written.
#pragma once

#include <string>
#include <vector>

#include "tb/cli/common.h"
#include "tb/sim/bench.h"

namespace cosim::cli {

/// The benches whose waves --wave draws. One bench draws into the file itself; of several each
/// draws into wave_file (wave.h) with its design's name as the part.
using WavesOf = std::vector<const AnyBench*>;

/// InputError if --csv, --report, --junit, --checkpoint, --plot, --html or --wave names no file, or
/// one that cannot be written, or one of `inputs`, or the file that standard output goes to; if two
/// of them name the same file, those beside a wave included; and if --failures names no folder.
/// Leaves all files as they are. To be called last, when all other input has been checked.
void check_outputs(const Common& common, const std::vector<std::string>& inputs = {},
                   const WavesOf& waves = {});

}  // namespace cosim::cli
