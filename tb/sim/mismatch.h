// What a difference between RTL and model looks like, for any design: the first clock and signal,
// and every signal on the clocks around it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "model/core/fields.h"
#include "tb/sim/stimulus.h"

namespace cosim {

/// One signal on the clocks of a window.
struct Trace {
  enum class Kind { input, reg, output };
  Field field;
  Kind kind = Kind::input;
  std::vector<Word> expected;  ///< one entry a clock; an input has the same in both
  std::vector<Word> actual;
  std::vector<bool> left_out{};  ///< where it was not compared; empty where it always was

  bool compared(std::size_t clock) const { return left_out.empty() || !left_out[clock]; }
  bool differs(std::size_t clock) const {
    return compared(clock) && expected[clock] != actual[clock];
  }
};

/// Clocks shown before and after the first difference.
struct Window {
  std::uint64_t before = 8;
  std::uint64_t after = 4;
};

/// What a wave shows by default.
inline constexpr Window wave_window{200, 50};

/// A case that is smaller and fails as well.
struct SmallerCase {
  std::string what;  ///< the case, one line
  Stimulus stimulus;
};

class AnyBench;

/// The first difference between RTL and model.
struct Mismatch {
  /// How many clocks the stimulus has after the first difference, for a wave to show.
  static constexpr std::uint64_t clocks_behind = 200;

  const AnyBench* bench = nullptr;  ///< the machine; null if no bench ran
  std::uint64_t clock = 0;          ///< clocks after the reset, from 0: the first with a difference
  std::string signal;  ///< the first differing signal in table order, registers before outputs
  Field field{};
  Word expected = 0;
  Word actual = 0;
  /// What is wrong, one line, where it is more than a signal's value; else empty. Without a value
  /// the width of `field` is 0.
  std::string finding;
  std::vector<std::string> told;  ///< what the model says in words of its own, lines
  std::uint64_t first = 0;        ///< the clock of the traces' first entry
  std::vector<Trace> traces;      ///< inputs, registers, outputs, in table order
  /// Leads to the same difference. The caller fills in machine and origin. It may start from a
  /// state, long after clock 0.
  Stimulus stimulus;
  /// Looks for a smaller case of the same kind: fewer or smaller jobs. Empty if the case has no
  /// jobs.
  std::function<SmallerCase()> smaller_case;
};

/// What differs, and where. Lines end in '\n', here and below.
std::string difference_text(const Mismatch& mismatch);

/// The clocks around it as a table of at most 120 columns, expected above actual where they differ,
/// "-" where nothing was compared. Where it had more than 40 rows: what changes, on 5 clocks.
std::string table_text(const Mismatch& mismatch);

/// Both.
std::string to_text(const Mismatch& mismatch);

/// Throws the InputError of a case that failed and does not fail so when it runs again.
[[noreturn]] void refuse_unsteady(const std::string& title);

}  // namespace cosim
