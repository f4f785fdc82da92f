#include "tb/support/leftover.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/syscall.h>
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

// Again from the start, until none is left: what is removed may move the others.
void remove_files_in(int folder) {
  alignas(long) char entries[4096];
  bool removed = true;
  while (removed) {
    removed = false;
    lseek(folder, 0, SEEK_SET);
    for (long n = 0; (n = syscall(SYS_getdents64, folder, entries, sizeof entries)) > 0;) {
      for (long at = 0; at < n;) {
        const auto* entry = reinterpret_cast<const dirent64*>(entries + at);
        removed |= unlinkat(folder, entry->d_name, 0) == 0;
        at += entry->d_reclen;
      }
    }
  }
}

void remove_at(const char* path) {
  if (unlink(path) == 0 || errno != EISDIR) return;
  const int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  remove_files_in(folder);
  close(folder);
  rmdir(path);
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
  if (!path_.empty()) remove_at(path_.c_str());
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
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGXCPU}) {
    if (std::signal(signal, end) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace cosim
