// What is claimed of one machine: RTL and golden model are the same for ever.
//
//   base case  after the clocks that reset the machine, whatever registers and state held before,
//   the
//           registers hold the values of the model's state after a reset, and that state satisfies
//           the invariant; of a machine that nothing resets: its initial values are that state's
//   step    from every state that satisfies the invariant, with the registers holding its
//           values, under every input: outputs and registers after the clock are those of
//           the model, and the state after it satisfies the invariant
//   cases   the same hypotheses can hold together with each of the design's cases
//   legal   where the design says which inputs are legal in a state, and the others assume no other
//           ones: in every state that satisfies the invariant some are
//
//   asserts under the same hypotheses what the RTL asserts itself is true on every clock
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
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tb/proof/from_reset.h"
#include "tb/proof/machine.h"
#include "tb/proof/net_questions.h"
#include "tb/proof/rtl.h"
#include "tb/proof/solver.h"

namespace cosim::proof {

/// A script with one or more questions.
struct Query {
  std::vector<std::string> asks;  ///< what each question asks, a few words
  std::string script;
};
/// A claim, as questions that must all be answered alike.
struct Claim {
  std::string what;  ///< a sentence
  Answer wanted = Answer::unsat;
  std::vector<Query> queries;
  std::vector<std::string> terms;  ///< whose values make a counterexample; may be empty
  /// The same claim on nets; null where it is not asked of nets.
  std::shared_ptr<const NetQuestions> nets = nullptr;
  /// What must never happen from reset, where the engines do not prove the claim: a state that
  /// refutes it may be one that is never reached. Where there is neither script nor nets, that is
  /// all of the claim.
  std::optional<Happens> from_reset = std::nullopt;
};

/// All that is claimed of a machine, as scripts and as nets. InputError as below, of a machine with
/// nothing unobserved.
std::vector<Claim> claims_of(const MachineFormula& machine, const nets::Model& model,
                             const Source& source);

// Each as scripts alone.

/// InputError where the RTL's registers, inputs and outputs are not those of the machine's tables,
/// one for one.
Claim claim_base_case(const MachineFormula& machine, const Rtl& rtl);
Claim claim_step(const MachineFormula& machine, const Rtl& rtl);
/// For RTL that asserts something.
Claim claim_asserts(const MachineFormula& machine, const Rtl& rtl);
Claim claim_cases(const MachineFormula& machine);
/// For a machine whose inputs are not all legal.
Claim claim_legal(const MachineFormula& machine);

}  // namespace cosim::proof
