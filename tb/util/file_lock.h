// A file that one process at a time holds: what only one may do at once.
#pragma once

#include <filesystem>

namespace cosim {

class FileLock {
 public:
  enum class Held { kWait, kRefuse };

  /// Locks the file, which it makes and leaves, until it goes out of scope or the process ends.
  /// Where another process holds it: waits, or InputError. InputError where it cannot be made.
  FileLock(const std::filesystem::path& file, Held held);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int file_;
};

}  // namespace cosim
