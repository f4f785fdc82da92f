// How far a sweep is: a bar that redraws itself on a terminal, a plain line a sweep elsewhere.
#pragma once

#include <chrono>
#include <string>

#include "tb/sweep/sweep.h"

namespace cosim::cli {

class ProgressLine {
 public:
  explicit ProgressLine(std::string title);

  /// To be called by the sweep; must not outlive this. Empty if standard output is no terminal.
  Progress callback();

  /// Ends with a plain line: `text` and the seconds taken.
  void finish(const std::string& text);

 private:
  void draw(std::uint64_t done, std::uint64_t cases) const;
  std::string title_;
  bool terminal_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// One line that tells how things stand, on a terminal alone; removed with this object.
class StateLine {
 public:
  StateLine();
  ~StateLine();
  StateLine(const StateLine&) = delete;
  StateLine& operator=(const StateLine&) = delete;
  void show(const std::string& text) const;

 private:
  bool terminal_;
};

/// How far one long run is: the same bar, shown after a moment and removed at the end.
class RunProgress {
 public:
  /// `wanted`: false if the run prints other things to the terminal.
  RunProgress(std::string title, std::uint64_t total, bool wanted);
  ~RunProgress() { clear(); }
  RunProgress(const RunProgress&) = delete;
  RunProgress& operator=(const RunProgress&) = delete;

  /// To be called for every clock or step, from 1.
  void at(std::uint64_t done) {
    constexpr std::uint64_t seldom = (1U << 16) - 1;
    if ((done & seldom) == 0 && draw_) draw(done);
  }
  /// Takes the bar away.
  void clear();

 private:
  void draw(std::uint64_t done);
  ProgressLine line_;
  std::uint64_t total_;
  Progress draw_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point due_;
};

}  // namespace cosim::cli
