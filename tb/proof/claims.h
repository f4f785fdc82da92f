// What is claimed of one machine: RTL and golden model are the same for ever.
//
//   base case  after the clocks that reset the machine, whatever registers and state held before,
//           the registers hold the values of the model's state after a reset, and that state
//           satisfies the invariant; of a machine that nothing resets: its initial values are that
//           state's
//   step    from every state that satisfies the invariant, with the registers holding its
//           values, under every input: outputs and registers after the clock are those of
//           the model, and the state after it satisfies the invariant
//   cases   the same hypotheses can hold together with each of the design's cases
//   legal   where the design says which inputs are legal in a state, and the others assume no other
//           ones: in every state that satisfies the invariant some are
//
//   asserts from reset on what the RTL asserts itself is true on every clock
//
// A register or an output that the design compares on some clocks only may hold anything on the
// others, in what is assumed and in what is claimed.
//
// Under an asynchronous reset what the registers show during a clock is claimed as well: yosys
// makes of such a register one that is reset by the clock, and of its net a choice by the reset.
//
// Where registers or outputs of the RTL are unobserved, the model has no place for all that a state
// of the RTL is, and in place of the first two there is one:
//
//   reset   from reset on outputs and registers that are compared are always the same
//
// The first two are an induction over the clocks: nothing else is assumed of the inputs, and no
// bound is set. The others show that the hypotheses of the second can be met.
//
// A question has model and RTL in one graph with structural hashing, so that what both have alike
// is there once, and is a miter: one bit that is 1 where anything differs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tb/nets/model.h"
#include "tb/proof/product.h"
#include "tb/proof/questions.h"
#include "tb/proof/rtl_nets.h"

namespace cosim::proof {

/// A claim, as questions that must all be answered alike.
struct Claim {
  std::string what;  ///< a sentence
  Answer wanted = Answer::unsat;
  /// None where it is asked from reset alone. Its terms are those of a counterexample.
  Questions questions{};
  /// What must never happen from reset, where the engines do not prove the claim: a state that
  /// refutes it may be one that is never reached.
  std::optional<Happens> from_reset = std::nullopt;
};

/// All that is claimed of a machine; runs yosys on `source`. InputError as of the others.
std::vector<Claim> claims_of(const nets::Model& model, const Source& source);

// Each of them. InputError where the RTL's flip-flops, inputs and outputs are not those of the
// machine's tables, one for one.

Claim claim_base_case(const nets::Model& model, const RtlNets& rtl);
Claim claim_step(const nets::Model& model, const RtlNets& rtl);
Claim claim_cases(const nets::Model& model);
/// For a machine whose inputs are not all legal.
Claim claim_legal(const nets::Model& model);

}  // namespace cosim::proof
