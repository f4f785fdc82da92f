#include "model/linear/checker.h"

#include "model/linear/job.h"
#include "model/linear/oracle.h"

namespace cosim::linear {

Checker<Word> checker_of(const Params& p, const Job& job) {
  return {ticks(p.gamma(), job.line.major), 0};
}

}  // namespace cosim::linear
