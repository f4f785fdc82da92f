#include "model/circular/host.h"

namespace cosim::circular {

bool Host::next(Inputs<Word>& in, const Outputs<Word>& seen) {
  in = Design::rest();
  if (age_ > 0) {
    // The start shows in `running` one clock later.
    const bool first = age_ == 1;
    if (!first) steps_ += seen.step_y | seen.step_x;
    if (first || seen.running) {
      ++age_;
      in.stop = arcs_[job_].count && steps_ >= *arcs_[job_].count;
      return true;
    }
    age_ = 0;
    ++job_;
  }
  if (job_ == arcs_.size()) return false;
  const Setup s = setup(arcs_[job_].from, arcs_[job_].radius2);
  in.load = 1;
  in.start = 1;
  in.sector2 = s.sector2;
  in.f = low_bits(s.f, p_.width + 2);
  in.ct7 = low_bits(to_ones_complement(s.ct7, p_.width + 1), p_.width + 1);
  in.ct8 = low_bits(to_ones_complement(s.ct8, p_.width + 1), p_.width + 1);
  age_ = 1;
  steps_ = 0;
  return true;
}

}  // namespace cosim::circular
