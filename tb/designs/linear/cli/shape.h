// The shape of the linear design on the command line.
#pragma once

#include "model/linear/job.h"
#include "tb/program/shape.h"

namespace cosim::linear {

std::vector<cli::ShapeOption> shape_options();

/// The smallest built one of that shape with major < 2^M. InputError where none holds it.
const Bench<Design>& bench_for(const cli::Shape& shape, std::int64_t major);

}  // namespace cosim::linear
