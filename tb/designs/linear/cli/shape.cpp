#include "tb/designs/linear/cli/shape.h"

#include <fmt/core.h>

#include "model/core/input_error.h"

namespace cosim::linear {

std::vector<cli::ShapeOption> shape_options() {
  return {{"M", "--m", 2, "Linear machine: bits of BP and UK"},
          {"N", "--n", 1, "Linear machine: bits of its tick count; 2^(M-N) steps a clock"}};
}

const Bench<Design>& bench_for(const cli::Shape& shape, std::int64_t major) {
  const auto found = cli::matching<Design>(shape);
  for (const auto* bench : found) {
    if (major >> bench->params().m == 0) return *bench;
  }
  throw InputError(fmt::format("a line of {} major steps does not fit {}: BP < 2^{}", major,
                               found.back()->title(), found.back()->params().m));
}

}  // namespace cosim::linear
