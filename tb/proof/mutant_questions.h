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
//
// Flip-flops that are no register's are free on both sides.
#pragma once

#include <vector>

#include "tb/proof/claims.h"

namespace cosim::proof {

/// That `reached` is true after a reset and stays so, by the model alone.
Claim reached_claim(const nets::Model& model);

struct MutantQuestions {
  enum class Known { same, other, asked };
  std::vector<Known> known;  ///< of each mutant, where nothing has to be asked
  Questions questions;       ///< a bit for each of the others, in their order
};

/// Whether each of these mutants is another machine than the RTL without one. `rtl` has the input
/// mutsel. InputError where its nets are not those of the tables.
MutantQuestions questions_of_mutants(const nets::Model& model, const RtlNets& rtl,
                                     const std::vector<unsigned>& numbers);
/// The step of one of them, with the terms of a counterexample: the model's are those of the RTL
/// without a mutant.
Questions question_of_mutant(const nets::Model& model, const RtlNets& rtl, unsigned number);

}  // namespace cosim::proof
