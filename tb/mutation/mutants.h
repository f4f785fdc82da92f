// Mutants: small faults planted by a program, each turned on by a number.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tb/bench/bench.h"

namespace cosim::mutation {

/// What became of a mutant.
struct Outcome {
  enum class End {
    open,        ///< not yet decided
    killed,      ///< RTL and model differed
    equivalent,  ///< proved to be the same machine
    survived,    ///< neither, after all stimuli
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
};

/// The cheapest first. The first `quick` of them kill nearly every mutant that can be killed: what
/// they leave is given to the prover.
struct Cases {
  std::vector<Case> all;
  std::size_t quick = 0;
};

/// What chooses a mutant, `mutsel`, has 16 bits, and 0 is none.
inline constexpr unsigned most_mutants = 65535;

/// The RTL of one design at one set of parameters, with its mutants.
class Subject {
 public:
  virtual ~Subject() = default;

  virtual const AnyBench& bench() const = 0;
  virtual const Cases& cases() const = 0;
  /// What each mutant is, in the words of yosys's `mutate`; number 1 first.
  virtual const std::vector<std::string>& mutants() const = 0;
  /// A Verilog file that holds these, and perhaps others; its input `mutsel` chooses one.
  virtual void write_verilog(const std::vector<unsigned>& mutants,
                             const std::filesystem::path& file) const = 0;

  using Decide = std::function<void(unsigned mutant, Outcome)>;
  /// Runs cases first .. last - 1 on each of these mutants, on `threads` threads, until one kills
  /// it; calls killed(mutant, outcome), from several threads, for those that are killed. InputError
  /// where RTL and model differ without a mutant.
  virtual void attack(const std::vector<unsigned>& mutants, std::size_t first, std::size_t last,
                      unsigned threads, const Decide& killed) const = 0;
  /// One case on one of them, on the calling thread; open where it does not kill it.
  virtual Outcome attack(unsigned mutant, const Case& one) const = 0;
};

/// The program around a subject, whose --help says what it takes. The exit status.
int main_of(const Subject& subject, int argc, char** argv);

}  // namespace cosim::mutation
