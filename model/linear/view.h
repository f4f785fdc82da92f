// What a person wants to see of the linear machine beside its registers: in a waveform, for
// example.
#pragma once

#include <array>

#include "model/linear/steps.h"
#include "model/plane/path_probes.h"

namespace cosim::linear {

/// Follows a machine through its clocks.
class View {
 public:
  static constexpr std::array phases{"idle", "ready", "start", "words"};
  static constexpr std::array steps{"-", "major", "both", "mixed"};

  static constexpr auto probes(const Params&) { return plane::path_probes(phases, steps); }

  /// One clock: the state before it and the outputs during it.
  void clock(const Params&, const State<Word>& s, const Outputs<Word>& out) {
    x_ = next_x_;
    y_ = next_y_;
    phase_ = s.formed ? 3 : s.running ? 2 : s.coded ? 1 : 0;
    if (phase_ == 2) x_ = y_ = 0;
    step_ = out.major == 0 ? 0 : out.minor == 0 ? 1 : out.minor == out.major ? 2 : 3;
    const Way way = way_of(out);
    next_x_ = x_ + way.x;
    next_y_ = y_ + way.y;
  }

  /// The phase, the steps of the clock's word, and the position in the present line before them, in
  /// steps: x along the major axis.
  std::array<Word, 4> values() const { return {phase_, step_, x_, y_}; }

 private:
  Word x_ = 0, y_ = 0, next_x_ = 0, next_y_ = 0;
  Word phase_ = 0, step_ = 0;
};

}  // namespace cosim::linear
