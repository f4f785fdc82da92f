// The shape of the dda design on the command line.
#pragma once

#include <fmt/core.h>

#include "tb/cli/shape.h"
#include "tb/designs/dda/design.h"

namespace cosim::dda {

inline std::vector<cli::ShapeOption> shape_options() {
  return {{"W", "--width", 2, "DDA: bits of an accumulator"}};
}

/// The smallest built one of that shape at least `width` wide. InputError where none is.
inline const Bench<Design>& bench_for(const cli::Shape& shape, int width) {
  return cli::first_that<Design>(
      shape, [=](const Params& p) { return width <= width_of(p); },
      [=](const Bench<Design>& last) {
        return fmt::format("a curve that needs {} bits does not fit {}", width, last.title());
      });
}

}  // namespace cosim::dda
