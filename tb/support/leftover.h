// What is not whole yet, and shall not be left behind: not by an error, and not by a signal.
#pragma once

#include <string>

namespace cosim {

/// A file, or a folder with files alone in it, that is being written: gone with this, and where a
/// signal ends the program.
class Leftover {
 public:
  /// To be made before the file is.
  explicit Leftover(std::string path);
  ~Leftover();
  Leftover(const Leftover&) = delete;
  Leftover& operator=(const Leftover&) = delete;

  const std::string& path() const { return path_; }
  /// It is whole, or has another name by now.
  void keep();

 private:
  std::string path_;
  int slot_ = -1;
};

/// From then on SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE and SIGXCPU, where they are not ignored,
/// remove all that is left over before they end the program, and a file that grows too large is an
/// error of its writer.
void remove_leftovers_on_signals();

}  // namespace cosim
