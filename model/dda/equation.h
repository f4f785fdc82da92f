// The equation of the curve that a job draws, and how a point lies to it. What stands on the curve
// is the job's start.
#pragma once

#include <utility>

#include "model/dda/curve.h"

namespace cosim::dda {

/// How far `at` is off the curve of a job, in steps: of a line along the axis with fewer steps, of
/// a circle along its radius, of another conic across the curve: by its equation over its gradient
/// where that is the distance but for an eighth of it, else the distance. Finite, whatever the job.
double deviation(const Job& job, Point at);

/// The curve's point next to `at`, to the digits of a picture; one of them where there are several.
std::pair<double, double> on_curve(const Job& job, Point at);

}  // namespace cosim::dda
