// What a person wants to see of the DDA beside its registers: in a waveform, for example.
#pragma once

#include <array>

#include "model/dda/steps.h"
#include "model/plane/path_probes.h"

namespace cosim::dda {

/// Follows a machine through its clocks.
class View {
 public:
  static constexpr std::array phases{"idle", "shift", "add", "end"};
  static constexpr std::array steps{"X- Y-", "X-",    "X- Y+", "Y-",   "-",
                                    "Y+",    "X+ Y-", "X+",    "X+ Y+"};

  static constexpr auto probes(const Params&) { return plane::path_probes(phases, steps); }

  /// One clock: the state before it and the outputs during it.
  void clock(const Params& p, const State<Word>& s, const Outputs<Word>& out) {
    x_ = s.x;
    y_ = s.y;
    const bool done = !s.free && s.left_x == 0 && s.left_y == 0;
    const bool shift = s.normalise && !is_full(p, s.rate_x) && !is_full(p, s.rate_y);
    phase_ = !s.running ? 0 : done ? 3 : shift ? 1 : 2;
    const Point step = step_of(out);
    step_ = 3 * step.x + step.y + 4;
  }

  /// The phase, the steps of the clock, and the point before them.
  std::array<Word, 4> values() const { return {phase_, step_, x_, y_}; }

 private:
  Word x_ = 0, y_ = 0;
  Word phase_ = 0, step_ = 4;
};

}  // namespace cosim::dda
