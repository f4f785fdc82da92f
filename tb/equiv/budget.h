// How much time is left for a question, by the clock on the wall.
#pragma once

#include <chrono>

namespace cosim::equiv {

struct OutOfTime {};

class Budget {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Budget(int seconds)
      : began_(Clock::now()), ends_(began_ + std::chrono::seconds(seconds)) {}
  Clock::duration spent() const { return Clock::now() - began_; }
  /// When it is over.
  Clock::time_point ends() const { return ends_; }
  /// OutOfTime where none is left.
  void check() const {
    if (Clock::now() >= ends_) throw OutOfTime();
  }

 private:
  Clock::time_point began_, ends_;
};

}  // namespace cosim::equiv
