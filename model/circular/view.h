// What a person wants to see of the circular machine beside its registers: in a waveform, for
// example.
#pragma once

#include <array>

#include "model/circular/steps.h"
#include "model/plane/path_probes.h"

namespace cosim::circular {

/// Follows a machine through its clocks.
class View {
 public:
  static constexpr std::array phases{"idle", "sector 1", "change", "sector 2", "end"};
  static constexpr std::array steps{"-", "Y+", "X-", "X- Y+"};

  static constexpr auto probes(const Params&) { return plane::path_probes(phases, steps); }

  /// One clock: the state before it and the outputs during it.
  void clock(const Params&, const State<Word>& s, const Outputs<Word>& out) {
    x_ = next_x_;
    y_ = next_y_;
    if (s.t4 && !running_) {
      // An arc begins where the loaded counters say.
      x_ = s.t16 ? s.ct7 + 1 : s.ct7 + s.ct8 + 1;
      y_ = s.t16 ? s.ct7 + 1 - s.ct8 : s.ct7;
    }
    running_ = s.t4 != 0;
    phase_ = !s.t4 ? 0 : s.ct7 < 0 ? 4 : s.t16 ? 3 : s.ct8 < 0 ? 2 : 1;
    step_ = out.step_x * 2 + out.step_y;
    const Point step = step_of(out);
    next_x_ = x_ + step.x;
    next_y_ = y_ + step.y;
  }

  /// The phase, the steps of the clock, and the position in the plane of the arc before them; the
  /// last one after the end.
  std::array<Word, 4> values() const { return {phase_, step_, x_, y_}; }

 private:
  Word x_ = 0, y_ = 0, next_x_ = 0, next_y_ = 0;
  bool running_ = false;
  Word phase_ = 0, step_ = 0;
};

}  // namespace cosim::circular
