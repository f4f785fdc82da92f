#include "tb/bench/bench.h"

#include <fmt/core.h>

namespace cosim {

std::string AnyBench::title() const {
  std::string text = design();
  for (const Parameter& p : parameters()) text += fmt::format(" {}={}", p.name, p.value);
  return text;
}

}  // namespace cosim
