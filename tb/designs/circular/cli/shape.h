// The shape of the circular design on the command line.
#pragma once

#include "model/circular/job.h"
#include "tb/program/shape.h"

namespace cosim::circular {

std::vector<cli::ShapeOption> shape_options();

/// The smallest built one of that shape at least `width` wide. InputError where none is.
const Bench<Design>& bench_for(const cli::Shape& shape, int width);

}  // namespace cosim::circular
