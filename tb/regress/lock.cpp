#include "tb/regress/lock.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "model/core/input_error.h"

namespace cosim::regress {

Lock::Lock(const std::filesystem::path& file)
    : file_(open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666)) {
  if (file_ < 0) {
    throw InputError(fmt::format("{}: cannot write: {}", file.string(), std::strerror(errno)));
  }
  if (flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(file_);
  throw InputError(file.parent_path().string() + ": another program runs it");
}

Lock::~Lock() { close(file_); }

}  // namespace cosim::regress
