// How much time is left for a question.
#pragma once

#include <algorithm>
#include <chrono>

namespace cosim::equiv {

struct OutOfTime {};

class Budget {
 public:
  explicit Budget(int seconds) : ends_(Clock::now() + std::chrono::seconds(seconds)) {}
  /// Whole seconds, >= 1. OutOfTime where none is left.
  int left() const {
    const double left = std::chrono::duration<double>(ends_ - Clock::now()).count();
    if (left <= 0) throw OutOfTime();
    return std::max(1, static_cast<int>(left));
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point ends_;
};

}  // namespace cosim::equiv
