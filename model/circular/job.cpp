#include "model/circular/job.h"

#include <algorithm>

namespace cosim::circular {

Due due_of(const Arc& arc) {
  const std::int64_t whole = steps_to_end(arc.from, arc.radius2);
  const std::int64_t steps = std::min(arc.count.value_or(whole), whole);
  const auto square = [](std::int64_t v) {
    return static_cast<std::uint64_t>(v) * static_cast<std::uint64_t>(v);
  };
  const std::uint64_t excess = square(arc.from.x) + square(arc.from.y) - arc.radius2;
  return {steps, steps == whole, end_point(arc.radius2).y, static_cast<std::int64_t>(excess)};
}

std::vector<Arc> smaller(const Arc& arc) {
  std::vector<Arc> arcs;
  // Whole radii from the axis on, by powers of two less.
  const std::int64_t radius = nearest_root(arc.radius2);
  const auto add = [&](std::int64_t r) {
    arcs.push_back({{r, 0}, static_cast<std::uint64_t>(r) * static_cast<std::uint64_t>(r), {}});
  };
  for (int i = 32; i >= 0; --i) {
    if (radius >> i > 1) add(radius - (std::int64_t{1} << i));
  }
  const auto r2 = static_cast<std::uint64_t>(radius) * static_cast<std::uint64_t>(radius);
  if (radius > 0 && (arc.from.y != 0 || arc.radius2 != r2)) add(radius);
  if (!arc.count && steps_to_end(arc.from, arc.radius2) > 0) {
    arcs.push_back(arc);
    arcs.back().count = steps_to_end(arc.from, arc.radius2) / 2;
  } else if (arc.count && *arc.count > 0) {
    for (const std::int64_t count : {*arc.count / 2, *arc.count - 1}) {
      arcs.push_back(arc);
      arcs.back().count = count;
    }
  }
  return arcs;
}

std::string describe(const Arc& arc) {
  std::string text = "R^2 = " + std::to_string(arc.radius2) + " from (" +
                     std::to_string(arc.from.x) + ", " + std::to_string(arc.from.y) + ")";
  if (arc.count) text += ", at most " + std::to_string(*arc.count) + " steps";
  return text;
}

}  // namespace cosim::circular
