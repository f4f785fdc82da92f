#include "tb/check.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>

#include "model/circular/oracle.h"
#include "model/linear/oracle.h"

namespace cosim {

void LineCheck::clock(std::size_t job, const Compared<linear::Design>& seen) {
  while (job_ < job) close();
  if (!seen.outputs.strobe || !found_.error.empty()) return;
  const linear::Line& line = jobs_[job].line;
  const linear::Words due = linear::words_at(p_.m, p_.gamma(), line, tick_);
  const linear::Words got = {static_cast<std::uint64_t>(seen.outputs.major),
                             static_cast<std::uint64_t>(seen.outputs.minor)};
  ++tick_;
  found_.steps += static_cast<std::uint64_t>(std::popcount(got.major));
  if (got == due) return;
  found_.error =
      fmt::format("BP = {}, UK = {:0{}b}, word {}: oracle {:0{}b} {:0{}b}, machine {:0{}b} {:0{}b}",
                  line.major, line.code, p_.m, tick_, due.major, p_.word(), due.minor, p_.word(),
                  got.major, p_.word(), got.minor, p_.word());
}

void LineCheck::close() {
  const linear::Job& job = jobs_[job_];
  const std::int64_t due = linear::ticks(p_.gamma(), job.line.major);
  if (found_.error.empty() && !job.words && tick_ != due) {
    found_.error = fmt::format("BP = {}, UK = {:0{}b}: oracle {} words, machine {}", job.line.major,
                               job.line.code, p_.m, due, tick_);
  }
  found_.max_deviation = std::max(
      found_.max_deviation, linear::max_deviation(p_.m, job.line.major, job.line.code).value());
  ++found_.jobs;
  ++job_;
  tick_ = 0;
}

Checked LineCheck::finish() {
  while (job_ < jobs_.size()) close();
  return found_;
}

ArcCheck::ArcCheck(std::span<const circular::Arc> arcs) : arcs_(arcs) { open(); }

void ArcCheck::open() {
  if (job_ == arcs_.size()) return;
  at_ = arcs_[job_].from;
  steps_ = 0;
  found_.max_deviation =
      std::max(found_.max_deviation, circular::radial_deviation(at_, arcs_[job_].radius2));
}

void ArcCheck::clock(std::size_t job, const Compared<circular::Design>& seen) {
  while (job_ < job) close();
  if (!(seen.outputs.step_x | seen.outputs.step_y) || !found_.error.empty()) return;
  const std::uint64_t radius2 = arcs_[job].radius2;
  ++steps_;
  ++found_.steps;
  const circular::Point got = {at_.x - seen.outputs.step_x, at_.y + seen.outputs.step_y};
  if (at_.x <= 0) {
    found_.error = fmt::format("R^2 = {}: a step past the end, at ({}, {})", radius2, at_.x, at_.y);
    return;
  }
  const circular::Point due = circular::next_point(at_, radius2);
  if (!(got == due)) {
    found_.error = fmt::format("R^2 = {}, step {} from ({}, {}): oracle ({}, {}), machine ({}, {})",
                               radius2, steps_, at_.x, at_.y, due.x, due.y, got.x, got.y);
    return;
  }
  at_ = got;
  found_.max_deviation = std::max(found_.max_deviation, circular::radial_deviation(at_, radius2));
}

void ArcCheck::close() {
  const circular::Arc& arc = arcs_[job_];
  if (found_.error.empty()) {
    const std::int64_t whole = circular::steps_to_end(arc.from, arc.radius2);
    const std::int64_t due = arc.count ? std::min(*arc.count, whole) : whole;
    const circular::Point end = circular::end_point(arc.radius2);
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

Checked ArcCheck::finish() {
  while (job_ < arcs_.size()) close();
  return found_;
}

}  // namespace cosim
