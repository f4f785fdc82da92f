#include "tb/cli/interrupt.h"

#include <atomic>
#include <csignal>

namespace cosim::cli {
namespace {

std::atomic<int> came{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may write no other");

void take_down(int number) {
  came = number;
  std::signal(number, SIG_DFL);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  came = 0;
  std::signal(SIGINT, take_down);
  std::signal(SIGTERM, take_down);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

int InterruptGuard::signal() { return came; }

void InterruptGuard::check() {
  if (came != 0) throw Interrupted{came};
}

}  // namespace cosim::cli
