// One program at a time goes on with a run.
#pragma once

#include <filesystem>

namespace cosim::regress {

class Lock {
 public:
  /// Locks the file, which it makes. InputError where another program holds it, or where it cannot
  /// be made.
  explicit Lock(const std::filesystem::path& file);
  ~Lock();
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int file_;
};

}  // namespace cosim::regress
