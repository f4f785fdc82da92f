// How far a sweep is: a bar that redraws itself on a terminal, a plain line a sweep elsewhere.
#pragma once

#include <chrono>
#include <string>

#include "tb/sweep.h"

namespace cosim::cli {

class ProgressLine {
 public:
  explicit ProgressLine(std::string title);

  /// To be called by the sweep; must not outlive this. No call where standard output is no
  /// terminal.
  Progress callback();

  /// Leaves a plain line: `text` and the seconds taken.
  void finish(const std::string& text);

 private:
  void draw(std::uint64_t done, std::uint64_t cases) const;
  std::string title_;
  bool terminal_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace cosim::cli
