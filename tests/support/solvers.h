// What a test of the proof needs.
#pragma once

#include "tb/support/process.h"

namespace cosim::test {

/// For one answer, in seconds of the solver's own processor time.
constexpr int kLimit = 60;

/// Whether the engines, and yosys where RTL is read, are installed.
inline bool can_prove() {
  for (const char* program : {"yosys", "yosys-abc", "cvc5", "z3"}) {
    if (run_program({program, "-h"}).status == 127) return false;
  }
  return true;
}

}  // namespace cosim::test
