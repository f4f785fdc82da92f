// Runs one case and takes down what came of it.
#pragma once

#include <string>

#include "tests/careless/draw.h"
#include "tests/careless/scratch.h"

namespace cosim::careless {

struct Came {
  int status = -1;    ///< 128 + n: it died by signal n
  bool hung = false;  ///< it did not end within `patience` of the signal
  bool signalled = false;
  int left = 0;   ///< processes that it left behind
  long peak = 0;  ///< bytes of memory, at its most
  double seconds = 0;
  std::string out, err;  ///< of a stream that is a file; of a long one its end
};

inline constexpr int patience = 15'000;  ///< milliseconds, of a busy computer
inline constexpr long longest_output = 200'000'000;

/// To be called once: what a case leaves behind becomes a child of this process, and its signals
/// are those that a shell would give it.
void adopt();

Came run(const std::string& program, const Case& one, const Scratch& scratch);

}  // namespace cosim::careless
