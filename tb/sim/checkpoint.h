// Work that can continue in another process. Progress is kept in a file that is always whole, even
// if the run is killed; a later run of the same work continues from it.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "tb/util/json_at.h"

namespace cosim {

class Checkpoint {
 public:
  /// `work` says what the work is and what its result depends on; the program itself is added. An
  /// empty path keeps nothing; `pace` is between two savings. InputError if the path is not that of
  /// a file.
  Checkpoint(std::string path, std::string work,
             std::chrono::milliseconds pace = std::chrono::milliseconds(100));

  /// The state last saved, none where there is no file. InputError where the file is no checkpoint,
  /// or one of other work or of another program.
  std::optional<JsonAt> state() const;
  /// Replaces the state. InputError where it cannot be written.
  void save(const Json& state);
  /// Whether it is time to save; never if nothing is kept.
  bool due() const;
  /// Removes the file. To be called when the result is known.
  void done();

 private:
  std::string path_;
  std::string work_;
  std::chrono::milliseconds pace_;
  std::chrono::steady_clock::time_point saved_ = std::chrono::steady_clock::now();
};

}  // namespace cosim
