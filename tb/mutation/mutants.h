// Mutants: small faults planted by a program, many in one Verilated class and chosen by a number.
#pragma once

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

/// One run of a fixed number of clocks on a bench; it follows from its name alone.
struct Case {
  std::string name;  ///< "hostile clocks, seed 1 case 3"
  std::function<Run()> run;
};

/// The RTL of one design at one set of parameters, with its mutants.
class Subject {
 public:
  Subject(std::string verilog, const std::string& list);
  virtual ~Subject() = default;

  virtual const AnyBench& bench() const = 0;
  /// Chooses the mutant, from 1, for all machines that the calling thread makes from now on; 0 is
  /// the unchanged RTL.
  virtual void choose(unsigned mutant) const = 0;
  /// The cheapest first. The first `quick()` of them kill nearly every mutant that can be killed.
  virtual const std::vector<Case>& cases() const = 0;
  virtual std::size_t quick() const = 0;

  /// The Verilog file that holds them; its input `mutsel` chooses one.
  const std::string& verilog() const { return verilog_; }
  /// What each mutant is, in the words of yosys's `mutate`; that of mutsel = 1 first.
  const std::vector<std::string>& mutants() const { return mutants_; }

 private:
  std::string verilog_;
  std::vector<std::string> mutants_;
};

/// Runs the stimuli first .. last - 1 on a mutant, on the calling thread, until one kills it.
/// Otherwise the outcome is open.
Outcome attack(const Subject& subject, unsigned mutant, std::size_t first, std::size_t last);

/// The program around a subject, whose --help says what it takes. The exit status.
int main_of(const Subject& subject, int argc, char** argv);

}  // namespace cosim::mutation
