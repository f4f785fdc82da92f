// What a person wants to see of the linear machine beside its registers: in a waveform, for
// example.
#pragma once

#include <array>
#include <bit>

#include "model/plane/path_probes.h"

namespace cosim::linear {

/// Follows a machine through its clocks.
class View {
 public:
  static constexpr std::array phases{"idle", "ready", "start", "words"};
  static constexpr std::array steps{"-", "major", "both", "mixed"};

  static constexpr auto probes() { return plane::path_probes(phases, steps); }

  /// One clock: the machine before it and the outputs during it.
  template <class Machine, class Out>
  void clock(const Machine& m, const Out& out) {
    x_ = next_x_;
    y_ = next_y_;
    phase_ = m.trigger30 ? 3 : m.trigger31 ? 2 : m.trigger32 ? 1 : 0;
    if (phase_ == 2) x_ = y_ = 0;
    const auto major = static_cast<std::uint64_t>(out.major);
    const auto minor = static_cast<std::uint64_t>(out.minor);
    step_ = major == 0 ? 0 : minor == 0 ? 1 : minor == major ? 2 : 3;
    next_x_ = x_ + std::popcount(major);
    next_y_ = y_ + std::popcount(minor);
  }

  /// The phase, the steps of the clock's word, and the position in the present line before them, in
  /// steps: x along the major axis.
  std::array<Word, 4> values() const { return {phase_, step_, x_, y_}; }

 private:
  Word x_ = 0, y_ = 0, next_x_ = 0, next_y_ = 0;
  Word phase_ = 0, step_ = 0;
};

}  // namespace cosim::linear
