#include "model/linear/host.h"

namespace cosim::linear {

bool Host::next(Inputs<Word>& in, const Outputs<Word>& seen) {
  in = Design::rest();
  if (phase_ == Phase::run) {
    words_ += seen.strobe;
    if (seen.busy) {
      in.initial_set_n = !(jobs_[job_].words && words_ >= *jobs_[job_].words);
      return true;
    }
    phase_ = Phase::bp;
    ++job_;
  }
  if (job_ == jobs_.size()) return false;
  const Line& line = jobs_[job_].line;
  switch (phase_) {
    case Phase::bp:
      in.write_bp = 1;
      in.data = line.major;
      words_ = 0;
      phase_ = Phase::uk;
      break;
    case Phase::uk:
      in.write_uk = 1;
      in.data = static_cast<Word>(line.code);
      phase_ = Phase::start;
      break;
    case Phase::start:
      in.start = 1;
      phase_ = Phase::rise;
      break;
    case Phase::rise:  // `busy` shows one clock after the start
    case Phase::run:
      phase_ = Phase::run;
      break;
  }
  return true;
}

}  // namespace cosim::linear
