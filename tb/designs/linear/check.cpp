#include "tb/designs/linear/check.h"

#include <fmt/core.h>

#include "model/linear/oracle.h"
#include "model/linear/steps.h"

namespace cosim::linear {

void Check::compare(const Job& job, const Compared<Design>& seen) {
  if (!seen.outputs.strobe) return;
  const Line& line = job.line;
  const Words due = words_at(p_.m, p_.gamma(), line, tick_);
  const Words got = {static_cast<std::uint64_t>(seen.outputs.major),
                     static_cast<std::uint64_t>(seen.outputs.minor)};
  ++tick_;
  drew(static_cast<std::uint64_t>(way_of(seen.outputs).x));  // positions of the major axis
  if (got == due) return;
  fail(
      fmt::format("BP = {}, UK = {:0{}b}, word {}: oracle {:0{}b} {:0{}b}, machine {:0{}b} {:0{}b}",
                  line.major, line.code, p_.m, tick_, due.major, p_.word(), due.minor, p_.word(),
                  got.major, p_.word(), got.minor, p_.word()));
}

void Check::close(const Job& job) {
  deviates(max_deviation(p_.m, job.line.major, job.line.code).value());
  const std::int64_t due = ticks(p_.gamma(), job.line.major);
  if (job.words || tick_ == due) return;
  fail(fmt::format("BP = {}, UK = {:0{}b}: oracle {} words, machine {}", job.line.major,
                   job.line.code, p_.m, due, tick_));
}

}  // namespace cosim::linear
