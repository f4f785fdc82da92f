#include "tb/designs/circular/check.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/circular/oracle.h"
#include "model/circular/steps.h"

namespace cosim::circular {

void Check::open(const Arc& arc) {
  at_ = arc.from;
  steps_ = 0;
  deviates(radial_deviation(at_, arc.radius2));
}

void Check::compare(const Arc& arc, const Compared<Design>& seen) {
  const Point step = step_of(seen.outputs);
  if (step == Point{}) return;
  ++steps_;
  drew(1);
  const Point got = {at_.x + step.x, at_.y + step.y};
  if (at_.x <= 0) {
    fail(fmt::format("R^2 = {}: a step past the end, at ({}, {})", arc.radius2, at_.x, at_.y));
    return;
  }
  const Point due = next_point(at_, arc.radius2);
  if (!(got == due)) {
    fail(fmt::format("R^2 = {}, step {} from ({}, {}): oracle ({}, {}), machine ({}, {})",
                     arc.radius2, steps_, at_.x, at_.y, due.x, due.y, got.x, got.y));
    return;
  }
  at_ = got;
  deviates(radial_deviation(at_, arc.radius2));
}

void Check::close(const Arc& arc) {
  const std::int64_t whole = steps_to_end(arc.from, arc.radius2);
  const std::int64_t due = arc.count ? std::min(*arc.count, whole) : whole;
  const Point end = end_point(arc.radius2);
  if (steps_ != due) {
    fail(fmt::format("R^2 = {} from ({}, {}): oracle {} steps, machine {}", arc.radius2, arc.from.x,
                     arc.from.y, due, steps_));
  } else if (due == whole && !(at_ == end)) {
    fail(fmt::format("R^2 = {} from ({}, {}): oracle ends at ({}, {}), machine at ({}, {})",
                     arc.radius2, arc.from.x, arc.from.y, end.x, end.y, at_.x, at_.y));
  }
}

}  // namespace cosim::circular
