#include "model/circular/walk.h"

#include <algorithm>

namespace cosim::circular {

Due<Word> due_of(const Params&, const Arc& arc) {
  const auto square = [](std::int64_t v) {
    return static_cast<std::uint64_t>(v) * static_cast<std::uint64_t>(v);
  };
  const std::int64_t whole = steps_to_end(arc.from, arc.radius2);
  const std::int64_t steps = std::min(arc.count.value_or(whole), whole);
  const std::uint64_t excess = square(arc.from.x) + square(arc.from.y) - arc.radius2;
  return {arc.from.x, arc.from.y,     static_cast<Word>(excess),
          steps,      steps == whole, end_point(arc.radius2).y};
}

}  // namespace cosim::circular
