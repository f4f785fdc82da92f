#include "tb/designs/dda/check.h"

#include <fmt/core.h>

#include "model/dda/equation.h"
#include "model/dda/steps.h"

namespace cosim::dda {

void Check::open(const Job& job) {
  track_.emplace(p_, job);
  clocks_ = 0;
  over_ = false;
}

void Check::compare(const Job& job, const Compared<Design>& seen) {
  if (!seen.outputs.busy) return;
  const auto signed_code = [this](Word code) { return from_twos_complement(code, p_.width + 1); };
  const Point from = track_->at();
  const Point at{signed_code(seen.outputs.code_x), signed_code(seen.outputs.code_y)};
  const Point got = step_of(seen.outputs);
  const std::optional<Point> due = track_->next();
  // On the clock of the end or of a stop there is no step.
  if (!due) over_ = true;
  if (!(at == from) || !(got == due.value_or(Point{}))) {
    fail(fmt::format(
        "{}, clock {}: oracle ({:+}, {:+}) from ({}, {}), machine ({:+}, {:+}) from ({}, {})",
        describe(p_, job), clocks_, due.value_or(Point{}).x, due.value_or(Point{}).y, from.x,
        from.y, got.x, got.y, at.x, at.y));
    return;
  }
  ++clocks_;
  if (got == Point{}) return;
  drew(1);
  deviates(deviation(job, track_->at()));
}

void Check::close(const Job& job) {
  if (over_) return;
  fail(fmt::format("{}: the machine ends after {} clocks, the oracle later", describe(p_, job),
                   clocks_));
}

}  // namespace cosim::dda
