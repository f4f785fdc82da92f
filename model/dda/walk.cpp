#include "model/dda/walk.h"

#include <cstdlib>

namespace cosim::dda {

Due<Word> due_of(const Params& p, const Job& job) {
  const Word larger = std::max(std::abs(job.start.rate_x), std::abs(job.start.rate_y));
  Due<Word> due;
  if (job.start.normalise == 0 || larger == 0) return due;
  while ((larger << due.shifts) >> (p.width - 1) == 0) ++due.shifts;
  return due;
}

Walked<Word> begun(const Params& p, const Job& job) {
  const State<Word>& s = job.start;
  Walked<Word> w;
  w.shifts = due_of(p, job).shifts;
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
