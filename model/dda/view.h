// What a person wants to see of the DDA beside its registers: in a waveform, for example.
#pragma once

#include <array>

#include "model/plane/path_probes.h"

namespace cosim::dda {

/// Follows a machine through its clocks.
class View {
 public:
  static constexpr std::array phases{"idle", "shift", "add", "end"};
  static constexpr std::array steps{"X- Y-", "X-",    "X- Y+", "Y-",   "-",
                                    "Y+",    "X+ Y-", "X+",    "X+ Y+"};

  static constexpr auto probes() { return plane::path_probes(phases, steps); }

  /// One clock: the machine before it and the outputs during it.
  template <class Machine, class Out>
  void clock(const Machine& m, const Out& out) {
    x_ = static_cast<Word>(m.x);
    y_ = static_cast<Word>(m.y);
    phase_ = !m.running ? 0 : m.is_done() ? 3 : m.is_to_shift() ? 1 : 2;
    step_ = 4;
    Machine::for_each_step(out, [&](int dx, int dy) { step_ += 3 * dx + dy; });
  }

  /// The phase, the steps of the clock, and the point before them.
  std::array<Word, 4> values() const { return {phase_, step_, x_, y_}; }

 private:
  Word x_ = 0, y_ = 0;
  Word phase_ = 0, step_ = 4;
};

}  // namespace cosim::dda
