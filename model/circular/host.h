// The device outside, SU 1665343: loads an arc, starts it, waits for its end or stops it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "model/circular/drive.h"
#include "model/circular/view.h"

namespace cosim::circular {

/// Drives the machine's pins through a list of arcs, one after the other. An arc takes one clock to
/// load and start, then a clock a step, one more for a sector change and one or two to end.
class Host {
 public:
  using Job = Arc;

  /// `arcs` must outlive the host.
  Host(const Params& p, std::span<const Arc> arcs) : p_(p), arcs_(arcs) {}

  /// The inputs of the next clock; false when the last arc is over. `seen`: the outputs of the
  /// clock before (of no meaning on the first call).
  bool next(Inputs<Word>& in, const Outputs<Word>& seen);

  /// Simpler arcs to try in place of an arc that shows a fault, the simplest first. Each is smaller
  /// in one respect and larger in none.
  static std::vector<Arc> smaller(const Params& p, const Arc& arc);
  /// "R^2 = 144 from (12, 0)"
  static std::string describe(const Params& p, const Arc& arc);

  /// The arc that the last inputs belong to, from 0.
  std::size_t job() const { return job_; }

 private:
  Params p_;
  std::span<const Arc> arcs_;
  std::size_t job_ = 0;
  bool is_first_ = true;
  Task<Word> task_;
  Driven<Word> driven_;
};

}  // namespace cosim::circular
