// What the RTL says of itself while it is evaluated: an assertion that fails, $error, $fatal, $stop
// or $finish. Verilator's library would end the program; said.cpp stands in it in place of that.
#pragma once

#include <string>

namespace cosim {

struct RtlSaid {
  std::string file;  ///< of the RTL, as Verilator was given it
  int line = 0;
  std::string text;

  /// "the RTL says: FILE:LINE: TEXT"
  std::string line_of_report() const {
    return "the RTL says: " + file + ':' + std::to_string(line) + ": " + text;
  }
};

/// Whether the RTL said something on this thread that take_said() has not taken.
inline thread_local bool rtl_said = false;

/// The first thing that it said since the last call.
RtlSaid take_said();

}  // namespace cosim
