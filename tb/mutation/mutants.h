// Mutants: small faults planted by a program, each turned on by a number.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tb/sim/bench.h"

namespace cosim {
class StreamDut;
struct StreamFinding;
}  // namespace cosim

namespace cosim::mutation {

/// What became of a mutant.
struct Outcome {
  enum class End {
    open,        ///< not yet decided
    killed,      ///< RTL and model differed
    equivalent,  ///< proved to be the same machine
    survived,    ///< neither, after all stimuli
    unread,      ///< it has no way to anything that is compared
  };
  End end = End::open;
  std::string stimulus;     ///< killed: by what
  std::uint64_t clock = 0;  ///< killed: the clock of the first difference, from 0
  std::string signal;       ///< killed: the first signal to differ
};

/// One run on a bench; it follows from its name alone.
struct Case {
  std::string name;  ///< "hostile clocks, case 3"
  std::function<Run()> run;
  /// The same run before a Watch, of a bench in lockstep.
  std::function<void(const Watch&)> watch = {};
  std::uint32_t power_up = 0;
  std::uint64_t most_clocks = std::uint64_t{1} << 18;  ///< before a Watch it is cut there
  /// Of a bench of streams in place of run and watch: what it finds on other RTL with the same
  /// ports.
  std::function<std::optional<StreamFinding>(StreamDut&)> finding_on = {};
};

/// The cheapest first. The first `quick` of them kill nearly every mutant that can be killed: what
/// they leave is given to the prover.
struct Cases {
  std::vector<Case> all;
  std::size_t quick = 0;
};

/// What chooses a mutant, `mutsel`, has 16 bits, and 0 is none.
inline constexpr unsigned most_mutants = 65535;

}  // namespace cosim::mutation
