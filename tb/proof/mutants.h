// The proof on mutants: RTL in which one of many small faults is turned on by an input.
//
// What is asked is whether a mutant is the same machine as the RTL without one, for ever, from the
// first clear on:
//
//   clear   after a clock that clears the machine, whatever its flip-flops held, the mutant's
//           registers hold the right values
//   step    from every state that satisfies the invariant and what else is true of all states
//           reached, with the registers of both holding the values of that state, under every
//           input: outputs, and registers after the clock, are the same
//
// That the RTL without a mutant is the same as the model is another claim (claims.h), so that all
// states after the clock are such states again; reached_claim() says so of the part that claims.h
// does not use. A mutant may change what lies between a flip-flop and its net: the net counts.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "tb/proof/decide.h"

namespace cosim::proof {

/// That `reached` is true after a clear and stays so, by the model alone, which may be null as
/// nets.
Claim reached_claim(const MachineFormula& machine, const nets::Model* model = nullptr);

/// Some of the mutants in a file, each as formulas of its own.
class Mutants {
 public:
  /// `verilog` has the machine as one module with the input `mutsel` of 16 bits: 0 turns none on, k
  /// the mutant of that number. InputError where yosys does not find it so.
  Mutants(const MachineFormula& machine, const std::filesystem::path& verilog,
          const std::vector<unsigned>& numbers);

  std::size_t size() const { return mutants_.size(); }
  Claim clear(std::size_t i) const;
  Claim step(std::size_t i) const;
  /// Whether every flip-flop has the clock it has without the mutant: the formulas know no other.
  bool has_same_clocks(std::size_t i) const { return mutants_[i].same_clocks; }

 private:
  struct Mutant {
    unsigned number;
    Rtl rtl;
    bool same_clocks;
  };
  const MachineFormula& machine_;
  std::vector<Rtl> original_;  // one
  std::vector<Mutant> mutants_;
};

/// What is known of a mutant.
struct Judged {
  bool same = false;       ///< proved by as many engines as are needed
  bool refuted = false;    ///< shown not to be, from a state that may never be reached
  bool timed_out = false;  ///< more time might help
  std::string verdict;
};

/// Has the engines judge mutants of one machine. yosys-abc is asked of many at once; what it shows
/// to differ nobody else is asked.
class Judge {
 public:
  /// `model`: the machine as nets; null where yosys-abc is not to be asked. Both must outlive it.
  Judge(const MachineFormula& machine, const nets::Model* model, Asking asking);

  /// Those of a Verilog file as of Mutants. May be called from several threads. InputError where an
  /// engine or yosys is missing.
  std::vector<Judged> judge(const std::filesystem::path& verilog,
                            const std::vector<unsigned>& numbers);

 private:
  void require_reached();
  std::vector<Opinion> opinions_of_abc(const std::filesystem::path& verilog,
                                       const std::vector<unsigned>& numbers) const;
  Judged judged_by(const Claim& step, const Claim& clear, std::vector<Opinion> opinions,
                   const std::vector<Engine>& engines, std::size_t needed) const;

  const MachineFormula& machine_;
  const nets::Model* model_;
  Asking asking_;
  std::once_flag once_;
};

}  // namespace cosim::proof
