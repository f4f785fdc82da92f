#include "model/linear/walk.h"

#include "model/linear/host.h"
#include "model/linear/oracle.h"

namespace cosim::linear {

Due<Word> due_of(const Params& p, const Job& job) { return {ticks(p.gamma(), job.line.major)}; }

}  // namespace cosim::linear
