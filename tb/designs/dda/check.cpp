#include "tb/designs/dda/check.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/dda/equation.h"
#include "model/dda/steps.h"

namespace cosim::dda {

Check::Check(const Params& p, std::span<const Job> jobs) : p_(p), jobs_(jobs) { open(); }

void Check::open() {
  if (job_ == jobs_.size()) return;
  track_.emplace(p_, jobs_[job_]);
  clocks_ = 0;
  over_ = false;
}

void Check::clock(std::size_t job, const Compared<Design>& seen) {
  while (job_ < job) close();
  if (!seen.outputs.busy || !found_.error.empty()) return;
  const auto signed_code = [this](Word code) { return from_twos_complement(code, p_.width + 1); };
  const Point from = track_->at();
  const Point at{signed_code(seen.outputs.code_x), signed_code(seen.outputs.code_y)};
  const Point got = step_of(seen.outputs);
  const std::optional<Point> due = track_->next();
  // On the clock of the end or of a stop there is no step.
  if (!due) over_ = true;
  if (!(at == from) || !(got == due.value_or(Point{}))) {
    found_.error = fmt::format(
        "{}, clock {}: oracle ({:+}, {:+}) from ({}, {}), machine ({:+}, {:+}) from ({}, {})",
        Host::describe(p_, jobs_[job_]), clocks_, due.value_or(Point{}).x, due.value_or(Point{}).y,
        from.x, from.y, got.x, got.y, at.x, at.y);
    return;
  }
  ++clocks_;
  if (got == Point{}) return;
  ++drawn_;
  max_deviation_ = std::max(max_deviation_, deviation(jobs_[job_], track_->at()));
}

void Check::close() {
  if (found_.error.empty() && !over_) {
    found_.error = fmt::format("{}: the machine ends after {} clocks, the oracle later",
                               Host::describe(p_, jobs_[job_]), clocks_);
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
  while (job_ < jobs_.size()) close();
  return so_far();
}

}  // namespace cosim::dda
