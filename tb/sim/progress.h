// How far a sweep is: a bar that redraws itself on a terminal, a plain line a sweep elsewhere.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "tb/sim/sweep.h"

namespace cosim::cli {

class ProgressLine {
 public:
  explicit ProgressLine(std::string title);

  /// To be called by the sweep; must not outlive this. Empty if standard output is no terminal.
  Progress callback();

  /// Ends with a plain line: `text` and the seconds taken, which it gives.
  double finish(const std::string& text);

 private:
  void draw(std::uint64_t done, std::uint64_t cases) const;
  std::string title_;
  bool terminal_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// One line that tells how things stand and for how long it goes on, on standard error: on a
/// terminal it redraws itself each second and is removed with this object, elsewhere one comes
/// every `often`.
class StateLine {
 public:
  using Seconds = std::chrono::seconds;
  explicit StateLine(Seconds often = Seconds(60));
  ~StateLine();
  StateLine(const StateLine&) = delete;
  StateLine& operator=(const StateLine&) = delete;
  /// What there is to tell from now on; `text` may be called from another thread.
  void show(std::function<std::string()> text);
  void show(const std::string& text) {
    show([text] { return text; });
  }
  /// Prints to standard output, above the line.
  void print(const std::string& text);

 private:
  void draw();
  void clear() const;

  bool terminal_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::function<std::string()> text_;
  std::mutex guard_;
  std::condition_variable ended_;
  bool ends_ = false;
  std::thread redraws_;
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
