#include "tb/designs/circular/cli/shape.h"

#include <fmt/core.h>

#include "model/core/input_error.h"

namespace cosim::circular {

std::vector<cli::ShapeOption> shape_options() {
  return {{"W", "--width", 2, "Circular machine: bits of a coordinate"}};
}

const Bench<Design>& bench_for(const cli::Shape& shape, int width) {
  const auto found = cli::matching<Design>(shape);
  for (const auto* bench : found) {
    if (width <= bench->params().width) return *bench;
  }
  throw InputError(
      fmt::format("an arc that needs {} bits does not fit {}", width, found.back()->title()));
}

}  // namespace cosim::circular
