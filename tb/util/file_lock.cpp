#include "tb/util/file_lock.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "model/core/input_error.h"

namespace cosim {

FileLock::FileLock(const std::filesystem::path& file, Held held)
    : file_(open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666)) {
  if (file_ < 0) {
    throw InputError(fmt::format("{}: cannot write: {}", file.string(), std::strerror(errno)));
  }
  int failed = 0;
  do {
    failed = flock(file_, held == Held::kWait ? LOCK_EX : LOCK_EX | LOCK_NB);
  } while (failed != 0 && errno == EINTR);
  // A file system without locks: as if nobody else were there.
  if (failed == 0 || errno != EWOULDBLOCK) return;
  close(file_);
  throw InputError(file.parent_path().string() +
                   ": another program is running it; wait for its end");
}

FileLock::~FileLock() { close(file_); }

}  // namespace cosim
