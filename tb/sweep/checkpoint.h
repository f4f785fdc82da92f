// Work that outlives its process. What is done so far stands in a file, which a run killed at any
// moment leaves whole; a run of the same work goes on from there.
#pragma once

#include <chrono>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace cosim {

class Checkpoint {
 public:
  using Json = nlohmann::json;

  /// `work` says what the work is and what its result depends on, but for the running program,
  /// which is added. An empty path keeps nothing. InputError where the path is no file's.
  Checkpoint(std::string path, std::string work);

  /// The state last saved, null where there is none. InputError where the file is no checkpoint, or
  /// one of other work or of another program.
  Json state() const;
  /// Replaces the state. InputError where it cannot be written.
  void save(const Json& state);
  /// Whether it is time to save: a moment after the last one, never where nothing is kept.
  bool due() const;
  /// To be called when the result is in: the file goes.
  void done();

 private:
  std::string path_;
  std::string work_;
  std::chrono::steady_clock::time_point saved_ = std::chrono::steady_clock::now();
};

}  // namespace cosim
