// The equation of the curve that a job draws, and where a point lies from it. The job's start is
// on the curve.
#pragma once

#include <utility>

#include "model/dda/curve.h"

namespace cosim::dda {

/// How far `at` is off the curve of a job, in steps: of a line along the axis with fewer steps, of
/// a circle along its radius, of another conic across the curve: by its equation over its gradient
/// where that is within an eighth of the distance, else the distance. Finite, whatever the job.
double deviation(const Job& job, Point at);

bool is_line_or_circle(const Job& job);
/// The same of one of these, where twice the left side of its equation has this value.
double deviation_by(const Job& job, std::int64_t twice);
/// That, within a millionth of it, at once; or no number.
double about_deviation_by(const Job& job, std::int64_t twice);

/// The curve's point next to `at`, to the digits of a picture; one of them where there are several.
std::pair<double, double> on_curve(const Job& job, Point at);

}  // namespace cosim::dda
