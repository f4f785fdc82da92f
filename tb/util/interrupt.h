// Ctrl-C in a long run: the run stops and reports what it has finished.
#pragma once

namespace cosim {

/// Thrown out of a run that was interrupted.
struct Interrupted {
  int signal = 0;
};

/// While a guard lives, SIGHUP, SIGINT, SIGQUIT and SIGTERM are only recorded; a second one ends
/// the program, and the first does where the guard still lives so many seconds later. One that
/// nobody has asked for until the last guard goes ends the program then.
class InterruptGuard {
 public:
  static constexpr unsigned seconds = 10;

  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// The signal that came, or 0.
  static int signal();
  /// Throws Interrupted if one came. May be called from any thread.
  static void check();
};

}  // namespace cosim
