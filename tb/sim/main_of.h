// A program that counts what the sweeps of one shape reach: its RTL was Verilated with counters.
#pragma once

#include <memory>
#include <vector>

#include "tb/sim/bench.h"
#include "tb/sim/model_lines.h"

namespace cosim::coverage {

/// How far a program is: the file FOLDER/progress, which it writes several times a second.
inline constexpr const char* progress_file = "/progress";

/// main() of PROGRAM FOLDER SEED CLOCKS JOBS: runs so many hostile clocks and, of a design that
/// declares jobs, so many random ones; the counts go to files in FOLDER (counts.h). Or of PROGRAM
/// FOLDER replay FILE...: runs the stimuli in these files. `counted`: lines of the model, which are
/// left there, too.
/// Status: 0 nothing differed; 1 something did, with a line that says what; 2 could not be run.
int main_of(const std::vector<std::unique_ptr<AnyBench>>& benches, int argc, char** argv,
            const Counted& counted = {});

}  // namespace cosim::coverage
