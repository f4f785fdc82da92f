#include "model/dda/checker.h"

#include <cstdlib>

namespace cosim::dda {

int shifts_of(const Params& p, const Job& job) {
  const Word larger = std::max(std::abs(job.start.rate_x), std::abs(job.start.rate_y));
  int shifts = 0;
  if (job.start.normalise == 0 || larger == 0) return shifts;
  while ((larger << shifts) >> (p.width - 1) == 0) ++shifts;
  return shifts;
}

Checker<Word> checker_of(const Params& p, const Job& job) {
  const State<Word>& s = job.start;
  Checker<Word> w;
  w.shifts = shifts_of(p, job);
  w.left = job.clocks.value_or(0);
  w.sum_x = s.sx;
  w.sum_y = s.sy;
  w.rate_x = s.rate_x;
  w.rate_y = s.rate_y;
  w.x = s.x;
  w.y = s.y;
  w.left_x = s.left_x;
  w.left_y = s.left_y;
  return w;
}

}  // namespace cosim::dda
