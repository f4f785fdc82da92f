#include "tb/bench/bench.h"

#include <fmt/core.h>

#include "model/core/input_error.h"

namespace cosim {

std::string AnyBench::title() const {
  std::string text = design();
  for (const Parameter& p : parameters()) text += fmt::format(" {}={}", p.name, to_text(p));
  return text;
}

Stimulus AnyBench::hostile(const HostileCase& /*c*/) const {
  throw InputError(design() + ": only a stimulus of it can be drawn");
}

std::string AnyBench::compared_text() const {
  return fmt::format("{} registers and {} outputs", registers(), compared().size() - registers());
}

void require_shape(const AnyBench& bench, const std::string& shape) {
  if (bench.title() == shape) return;
  throw InputError(
      fmt::format("{}: its model says it is {}: Design::name and parameters() are to be "
                  "those of cosim_add_design()",
                  shape, bench.title()));
}

}  // namespace cosim
