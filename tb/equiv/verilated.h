// Verilator's own library, which is a part of each of its programs and takes longer to compile than
// a small RTL: compiled once for a user.
#pragma once

#include <filesystem>

namespace cosim::equiv {

class VerilatedLibrary {
 public:
  /// `built`: the folder with what Verilator made of an RTL, under the name Vcosim_replay. The
  /// library is kept in $XDG_CACHE_HOME/cosim or ~/.cache/cosim, by a hash of Verilator, the
  /// compiler and their options; nowhere if there is no such folder.
  explicit VerilatedLibrary(std::filesystem::path built);

  /// Puts it where make looks for it, if it is kept.
  void put() const;
  /// Keeps what make has built.
  void keep() const;

 private:
  std::filesystem::path built_, kept_;
};

}  // namespace cosim::equiv
