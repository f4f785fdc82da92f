#include "tb/designs/circular/check.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/circular/oracle.h"
#include "model/circular/steps.h"

namespace cosim::circular {

Check::Check(std::span<const Arc> arcs) : arcs_(arcs) { open(); }

void Check::open() {
  if (job_ == arcs_.size()) return;
  at_ = arcs_[job_].from;
  steps_ = 0;
  max_deviation_ = std::max(max_deviation_, radial_deviation(at_, arcs_[job_].radius2));
}

void Check::clock(std::size_t job, const Compared<Design>& seen) {
  while (job_ < job) close();
  const Point step = step_of(seen.outputs);
  if (step == Point{} || !found_.error.empty()) return;
  const std::uint64_t radius2 = arcs_[job].radius2;
  ++steps_;
  ++drawn_;
  const Point got = {at_.x + step.x, at_.y + step.y};
  if (at_.x <= 0) {
    found_.error = fmt::format("R^2 = {}: a step past the end, at ({}, {})", radius2, at_.x, at_.y);
    return;
  }
  const Point due = next_point(at_, radius2);
  if (!(got == due)) {
    found_.error = fmt::format("R^2 = {}, step {} from ({}, {}): oracle ({}, {}), machine ({}, {})",
                               radius2, steps_, at_.x, at_.y, due.x, due.y, got.x, got.y);
    return;
  }
  at_ = got;
  max_deviation_ = std::max(max_deviation_, radial_deviation(at_, radius2));
}

void Check::close() {
  const Arc& arc = arcs_[job_];
  if (found_.error.empty()) {
    const std::int64_t whole = steps_to_end(arc.from, arc.radius2);
    const std::int64_t due = arc.count ? std::min(*arc.count, whole) : whole;
    const Point end = end_point(arc.radius2);
    if (steps_ != due) {
      found_.error = fmt::format("R^2 = {} from ({}, {}): oracle {} steps, machine {}", arc.radius2,
                                 arc.from.x, arc.from.y, due, steps_);
    } else if (due == whole && !(at_ == end)) {
      found_.error =
          fmt::format("R^2 = {} from ({}, {}): oracle ends at ({}, {}), machine at ({}, {})",
                      arc.radius2, arc.from.x, arc.from.y, end.x, end.y, at_.x, at_.y);
    }
  }
  ++found_.jobs;
  ++job_;
  open();
}

Checked Check::so_far() const {
  Checked found = found_;
  found.measures = {
      {"steps", Measure::Sum::total, "", "step", drawn_},
      {"max_deviation", Measure::Sum::largest, "largest deviation", "step", max_deviation_}};
  return found;
}

Checked Check::finish() {
  while (job_ < arcs_.size()) close();
  return so_far();
}

}  // namespace cosim::circular
