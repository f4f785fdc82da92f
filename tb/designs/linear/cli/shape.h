// The shape of the linear design on the command line.
#pragma once

#include <fmt/core.h>

#include "tb/cli/shape.h"
#include "tb/designs/linear/design.h"

namespace cosim::linear {

inline std::vector<cli::ShapeOption> shape_options() {
  return {{"M", "--m", 2, "Linear machine: bits of BP and UK"},
          {"N", "--n", 1, "Linear machine: bits of its tick count; 2^(M-N) steps a clock"}};
}

/// The smallest built one of that shape with major < 2^M. InputError where none is.
inline const Bench<Design>& bench_for(const cli::Shape& shape, std::int64_t major) {
  return cli::first_that<Design>(
      shape, [=](const Params& p) { return major >> sizes_of(p).m == 0; },
      [=](const Bench<Design>& last) {
        return fmt::format("a line of {} major steps does not fit {}: BP < 2^{}", major,
                           last.title(), sizes_of(last.params()).m);
      });
}

}  // namespace cosim::linear
