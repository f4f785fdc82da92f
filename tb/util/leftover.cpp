#include "tb/util/leftover.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <utility>

namespace cosim {
namespace {

// For a signal's handler, which may neither wait nor take memory. More at a time than any command
// writes; one that finds no slot is only not seen by signals.
struct Slot {
  std::atomic<bool> taken{false}, ready{false};
  char path[PATH_MAX] = {};
};
std::array<Slot, 64> slots;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may read no other");

void remove_at(const char* path) {
  if (unlink(path) == 0 || errno != EISDIR || fork() != 0) return;
  execl("/bin/rm", "rm", "-rf", "--", path, nullptr);
  _exit(1);
}

void end(int signal) {
  for (const Slot& slot : slots) {
    if (slot.ready) remove_at(slot.path);
  }
  std::signal(signal, SIG_DFL);
  raise(signal);
}

}  // namespace

Leftover::Leftover(std::string path) : path_(std::move(path)) {
  if (path_.size() >= PATH_MAX) return;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i].taken.exchange(true)) continue;
    std::memcpy(slots[i].path, path_.c_str(), path_.size() + 1);
    slots[i].ready = true;
    slot_ = static_cast<int>(i);
    return;
  }
}

Leftover::~Leftover() {
  if (!path_.empty()) unlink(path_.c_str());
  keep();
}

void Leftover::keep() {
  path_.clear();
  if (slot_ < 0) return;
  Slot& slot = slots[static_cast<std::size_t>(std::exchange(slot_, -1))];
  slot.ready = false;
  slot.taken = false;
}

void remove_leftovers_on_signals() {
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGXCPU, SIGBUS}) {
    if (std::signal(signal, end) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace cosim
