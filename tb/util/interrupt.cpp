#include "tb/util/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <mutex>

namespace cosim {
namespace {

std::atomic<int> came{0};
std::atomic<bool> is_known{false};  // somebody has asked for it
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may write no other");

std::mutex mutex;
int guards = 0;  // that live, on all threads
struct Taken {
  int number;
  void (*before)(int);
} handled[] = {{SIGHUP, SIG_DFL}, {SIGINT, SIG_DFL}, {SIGQUIT, SIG_DFL}, {SIGTERM, SIG_DFL}};

// Nobody has heeded the signal: it does what it would have done without a guard.
void heed(int) { raise(came); }

// The second one does what the first would have done without a guard; so does the first where it is
// not heeded, as by a model that loops for ever.
void take_down(int number) {
  came = number;
  alarm(InterruptGuard::seconds);
  for (const Taken& t : handled) {
    if (t.number == number) std::signal(number, t.before);
  }
}

}  // namespace

InterruptGuard::InterruptGuard() {
  const std::scoped_lock lock(mutex);
  if (guards++ > 0) return;
  came = 0;
  is_known = false;
  std::signal(SIGALRM, heed);
  for (Taken& t : handled) {
    t.before = std::signal(t.number, take_down);
    // As a shell starts what runs in its background.
    if (t.before == SIG_IGN) std::signal(t.number, SIG_IGN);
  }
}

InterruptGuard::~InterruptGuard() {
  const std::scoped_lock lock(mutex);
  if (--guards > 0) return;
  alarm(0);
  for (const Taken& t : handled) std::signal(t.number, t.before);
  if (came != 0 && !is_known) raise(came);
}

int InterruptGuard::signal() {
  if (came != 0) is_known = true;
  return came;
}

void InterruptGuard::check() {
  if (const int number = signal(); number != 0) throw Interrupted{number};
}

}  // namespace cosim
