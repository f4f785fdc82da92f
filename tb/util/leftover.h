// Removes unfinished files after an error or a signal.
#pragma once

#include <string>

namespace cosim {

/// A file that is being written. Removed with this object, and when a signal ends the program.
class Leftover {
 public:
  /// To be made before the file is.
  explicit Leftover(std::string path);
  ~Leftover();
  Leftover(const Leftover&) = delete;
  Leftover& operator=(const Leftover&) = delete;

  const std::string& path() const { return path_; }
  /// The file is finished or renamed: it is not removed any more.
  void keep();

 private:
  std::string path_;
  int slot_ = -1;
};

/// From then on SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGXCPU and SIGBUS, unless ignored,
/// remove all unfinished files before they end the program. A file that grows too large is a write
/// error.
void remove_leftovers_on_signals();

}  // namespace cosim
