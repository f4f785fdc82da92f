// Sweeps of the DDA: whole curves, checked in lockstep and against the oracle.
#pragma once

#include <cstdint>

#include "tb/designs/dda/design.h"
#include "tb/sim/bench.h"
#include "tb/sim/sweep.h"

namespace cosim::dda {

using DdaBench = Bench<Design>;

/// Every DX with every DY of the width, to all four sides, normalised and not, with either update
/// and either preload; a case is one DX.
Sweep every_line(const DdaBench& bench);

/// The quarter from (R, 0) for every R of the width, with either update and either preload; a case
/// is one R.
Sweep every_quarter(const DdaBench& bench);

/// The job that random case i draws: a line, an arc, a circle or an ellipse in any place, given up
/// after a random number of clocks where it is long.
Job random_job(int width, std::uint64_t seed, std::uint64_t i);

/// `count` random lines and arcs, in lanes too: the same but for circles and other conics, whose
/// whole way is walked before they are drawn.
Sweep random_lines_and_arcs(const DdaBench& bench, std::uint64_t seed, std::uint64_t count);

/// `count` random jobs; a case is one job.
Sweep random_jobs(const DdaBench& bench, std::uint64_t seed, std::uint64_t count);

}  // namespace cosim::dda
