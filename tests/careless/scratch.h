// The folder that a case runs in: in/, what may be read; work/, where it runs; tmp/ and home/.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace cosim::careless {

/// Good and odd files to be read, as seen from work/.
const std::vector<std::string>& input_names();

class Scratch {
 public:
  /// Everything as it is before a case. `root`: the repository, whose examples are among the
  /// inputs.
  explicit Scratch(const std::filesystem::path& root);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::filesystem::path work() const { return folder_ / "work"; }
  const std::filesystem::path& folder() const { return folder_; }

  /// Every file below it, by its path from there; of regular files what they hold (of a long one
  /// its size and end), of others their kind.
  std::map<std::string, std::string> holds() const;

 private:
  std::filesystem::path folder_;
};

}  // namespace cosim::careless
