// The files a command writes, looked at before it runs: a long run shall not end in an error that
// was there from its start, and no file is written over that is read or written otherwise.
#pragma once

#include <string>
#include <vector>

#include "tb/bench/bench.h"
#include "tb/cli/common.h"

namespace cosim::cli {

/// The benches whose waves --wave draws: of one it is the file, of several each has its design's
/// name for the part of wave_file, wave.h.
using WavesOf = std::vector<const AnyBench*>;

/// InputError where --csv, --report, --checkpoint, --plot or --wave names no file, where two would
/// write one and the same, what lies beside a wave included, where one of them is the file `input`
/// or the one that standard output goes to, and where any of them cannot be written; where
/// --failures names no folder. Leaves all files as they are. To be called when all other input has
/// proved good.
void check_outputs(const Common& common, const std::string& input = "", const WavesOf& waves = {});

}  // namespace cosim::cli
