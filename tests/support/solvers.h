// What a test of the proof needs.
#pragma once

#include "tb/util/process.h"

namespace cosim::test {

/// For one answer, in seconds of the solver's own processor time: only against one that never ends,
/// for how fast the machine is decides nothing.
constexpr int kLimit = 3600;

/// Whether the engines, and yosys where RTL is read, are installed.
inline bool can_prove() {
  for (const char* program : {"yosys", "yosys-abc"}) {
    if (!is_installed(program)) return false;
  }
  return true;
}

}  // namespace cosim::test
