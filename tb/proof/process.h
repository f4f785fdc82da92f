// Other programs, run to their end.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cosim::proof {

struct Ended {
  int status = 0;    ///< 127 where there is no such program, 128 + n where signal n ended it
  std::string text;  ///< what it printed, errors among it
};

/// Runs a program, found as a shell finds it, with nothing to read.
Ended run_program(const std::vector<std::string>& words);

/// A folder for files in between, gone with this.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace cosim::proof
