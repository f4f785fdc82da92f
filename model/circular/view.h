// What a person wants to see of the circular machine beside its registers: in a waveform, for
// example.
#pragma once

#include <array>

#include "model/plane/path_probes.h"

namespace cosim::circular {

/// Follows a machine through its clocks.
class View {
 public:
  static constexpr std::array phases{"idle", "sector 1", "change", "sector 2", "end"};
  static constexpr std::array steps{"-", "Y+", "X-", "X- Y+"};

  static constexpr auto probes() { return plane::path_probes(phases, steps); }

  /// One clock: the machine before it and the outputs during it.
  template <class Machine, class Out>
  void clock(const Machine& m, const Out& out) {
    x_ = next_x_;
    y_ = next_y_;
    if (m.t4 && !running_) {
      // An arc begins where the loaded counters say.
      const auto first = static_cast<Word>(m.ct7), across = static_cast<Word>(m.ct8);
      x_ = m.t16 ? first + 1 : first + across + 1;
      y_ = m.t16 ? first + 1 - across : first;
    }
    running_ = bool(m.t4);
    phase_ = !m.t4 ? 0 : m.ct7 < 0 ? 4 : m.t16 ? 3 : m.ct8 < 0 ? 2 : 1;
    const auto up = static_cast<Word>(out.step_y), left = static_cast<Word>(out.step_x);
    step_ = left * 2 + up;
    next_x_ = x_ - left;
    next_y_ = y_ + up;
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
