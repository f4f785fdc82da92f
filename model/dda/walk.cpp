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

}  // namespace cosim::dda
