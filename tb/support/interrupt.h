// Ctrl-C in a long run: the run stops where it is and says what it had finished.
#pragma once

namespace cosim {

/// Thrown out of a run that was interrupted.
struct Interrupted {
  int signal = 0;
};

/// While one lives, SIGINT and SIGTERM are only taken down; a second one ends the program.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// The signal that came, or 0.
  static int signal();
  /// Throws Interrupted where one came. May be called from any thread.
  static void check();
};

}  // namespace cosim
