// What a difference between RTL and model looks like, for any design: the first clock and signal,
// and every signal on the clocks around it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/core/fields.h"

namespace cosim {

/// One signal on the clocks of a window.
struct Trace {
  enum class Kind { input, reg, output };
  Field field;
  Kind kind = Kind::input;
  std::vector<Word> expected;  ///< one entry a clock; an input has the same in both
  std::vector<Word> actual;
};

/// Where RTL and model part.
struct Mismatch {
  std::uint64_t clock = 0;  ///< clocks after the clear, from 0: the first with a difference
  std::string signal;       ///< the first differing signal in table order, registers before outputs
  Field field{};
  Word expected = 0;
  Word actual = 0;
  std::uint64_t first = 0;    ///< the clock of the traces' first entry
  std::vector<Trace> traces;  ///< inputs, registers, outputs, in table order
};

/// The mismatch as text: what and where, then the table of the clocks around it, with expected
/// above actual wherever they differ, in parts one below the other where it is wider than 120
/// columns. Lines end in '\n'.
std::string to_text(const Mismatch& mismatch);

}  // namespace cosim
