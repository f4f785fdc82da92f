// The proof on mutants: RTL in which one of many small faults is turned on by an input.
//
// What is asked is whether a mutant is the same machine as the RTL without one, for ever, from the
// first reset on:
//
//   base case  after a clock that resets the machine, whatever its flip-flops held, the mutant's
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
#include <vector>

#include "tb/proof/claims.h"

namespace cosim::proof {

/// That `reached` is true after a reset and stays so, by the model alone, which may be null as
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
  Claim base_case(std::size_t i) const;
  /// In its counterexamples the model is the RTL without a mutant.
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

}  // namespace cosim::proof
