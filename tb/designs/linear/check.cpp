#include "tb/designs/linear/check.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/linear/oracle.h"
#include "model/linear/steps.h"

namespace cosim::linear {

void Check::clock(std::size_t job, const Compared<Design>& seen) {
  while (job_ < job) close();
  if (!seen.outputs.strobe || !found_.error.empty()) return;
  const Line& line = jobs_[job].line;
  const Words due = words_at(p_.m, p_.gamma(), line, tick_);
  const Words got = {static_cast<std::uint64_t>(seen.outputs.major),
                     static_cast<std::uint64_t>(seen.outputs.minor)};
  ++tick_;
  drawn_ += static_cast<std::uint64_t>(way_of(seen.outputs).x);
  if (got == due) return;
  found_.error =
      fmt::format("BP = {}, UK = {:0{}b}, word {}: oracle {:0{}b} {:0{}b}, machine {:0{}b} {:0{}b}",
                  line.major, line.code, p_.m, tick_, due.major, p_.word(), due.minor, p_.word(),
                  got.major, p_.word(), got.minor, p_.word());
}

void Check::close() {
  const Job& job = jobs_[job_];
  const std::int64_t due = ticks(p_.gamma(), job.line.major);
  if (found_.error.empty() && !job.words && tick_ != due) {
    found_.error = fmt::format("BP = {}, UK = {:0{}b}: oracle {} words, machine {}", job.line.major,
                               job.line.code, p_.m, due, tick_);
  }
  max_deviation_ =
      std::max(max_deviation_, max_deviation(p_.m, job.line.major, job.line.code).value());
  ++found_.jobs;
  ++job_;
  tick_ = 0;
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

}  // namespace cosim::linear
