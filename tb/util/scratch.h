// Folders for temporary files.
#pragma once

#include <filesystem>
#include <memory>

#include "tb/util/interrupt.h"

namespace cosim {

/// InputError, which names the folder that it lies in, where this one has no room for another file.
void require_room(const std::filesystem::path& folder);

/// A folder for temporary files, removed with this object, also after a signal that interrupts. It
/// lies in the one folder of this process, cosim.XXXXXX, which is all that is left where that is
/// killed. That one is in $TMPDIR, or in /tmp where there is none or where its name has a space or
/// another character that tools cannot take. InputError where there is no room.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  InterruptGuard interrupts_;
  std::shared_ptr<const std::filesystem::path> root_;
  std::filesystem::path path_;
};

}  // namespace cosim
