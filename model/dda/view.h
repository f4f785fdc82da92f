// What a person wants to see of the DDA beside its registers: in a waveform, for example.
#pragma once

#include <array>

#include "model/dda/machine.h"

namespace cosim::dda {

/// Follows a machine through its clocks.
class View {
 public:
  static constexpr std::array phases{"idle", "shift", "add", "end"};
  static constexpr std::array steps{"X- Y-", "X-",    "X- Y+", "Y-",   "-",
                                    "Y+",    "X+ Y-", "X+",    "X+ Y+"};

  /// One clock: the state before it and the outputs during it.
  void clock(const Params& p, const State<Word>& s, const Outputs<Word>& out) {
    x_ = s.x;
    y_ = s.y;
    const bool done = !s.free && s.left_x == 0 && s.left_y == 0;
    const bool shift = s.normalise && !is_full(p, s.rate_x) && !is_full(p, s.rate_y);
    phase_ = !s.running ? 0 : done ? 3 : shift ? 1 : 2;
    step_ = static_cast<std::size_t>(3 * (out.x_up - out.x_down) + out.y_up - out.y_down + 4);
  }

  /// The point before the clock's step.
  Word x() const { return x_; }
  Word y() const { return y_; }
  std::size_t phase() const { return phase_; }  ///< index into phases
  std::size_t step() const { return step_; }    ///< index into steps

 private:
  Word x_ = 0, y_ = 0;
  std::size_t phase_ = 0, step_ = 4;
};

}  // namespace cosim::dda
