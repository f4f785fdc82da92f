#include "tb/designs/dda/cli/shape.h"

#include <fmt/core.h>

#include "model/core/input_error.h"

namespace cosim::dda {

std::vector<cli::ShapeOption> shape_options() {
  return {{"W", "--width", 2, "DDA: bits of an accumulator"}};
}

const Bench<Design>& bench_for(const cli::Shape& shape, int width) {
  const auto found = cli::matching<Design>(shape);
  for (const auto* bench : found) {
    if (width <= bench->params().width) return *bench;
  }
  throw InputError(
      fmt::format("a curve that needs {} bits does not fit {}", width, found.back()->title()));
}

}  // namespace cosim::dda
