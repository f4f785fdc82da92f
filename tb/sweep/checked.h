// What an oracle found of what was drawn: a second opinion beside lockstep, on whole jobs.
#pragma once

#include <cstdint>
#include <string>

namespace cosim {

/// What a check found of a run of jobs.
struct Checked {
  std::uint64_t jobs = 0;   ///< finished
  std::uint64_t steps = 0;  ///< elementary steps: positions of a line, clocks with a step of an arc
  double max_deviation = 0;  ///< in steps, from the exact line or circle, over all jobs
  std::string error;         ///< empty, or one line: the first place where machine and oracle part
};

}  // namespace cosim
