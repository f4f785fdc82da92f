#include "model/circular/checker.h"

#include <algorithm>

namespace cosim::circular {

Checker<Word> checker_of(const Params&, const Arc& arc) {
  const std::int64_t whole = steps_to_end(arc.from, arc.radius2);
  const std::int64_t steps = std::min(arc.count.value_or(whole), whole);
  const auto square = [](std::int64_t v) {
    return static_cast<std::uint64_t>(v) * static_cast<std::uint64_t>(v);
  };
  const auto excess = static_cast<Word>(square(arc.from.x) + square(arc.from.y) - arc.radius2);
  return {
      steps == whole, end_point(arc.radius2).y, arc.from.x - 1, arc.from.y, excess, steps, excess,
      excess};
}

}  // namespace cosim::circular
