// A claim that an engine refuted, run in lockstep.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "tb/proof/counterexample.h"
#include "tb/proof/decide.h"
#include "tb/proof/from_reset.h"
#include "tb/sim/bench.h"

namespace cosim::cli {

/// What a failure folder calls the case.
inline constexpr const char* refuted_case = "counterexample of the proof";

struct Refuted {
  proof::Counterexample counterexample;
  Stimulus stimulus;
  Run run;  ///< of the stimulus; it matches where the RTL of the claim is not the bench's
};
/// The counterexample of a claim on `model`, that of `bench`; none where the claim was not refuted,
/// or has no terms.
std::optional<Refuted> refuted(const nets::Model& model, const AnyBench& bench,
                               const proof::Decision& decision);

/// What came of a claim that was asked from reset.
struct FromResetAnswer {
  proof::Ever ever = proof::Ever::open;
  std::string verdict;  ///< "proved from reset by ...", "REFUTED from reset: ...", "UNDECIDED: ..."
  bool is_checked = false;  ///< of never: it rests on a solver too that is none of abc's
  /// Of yes: what happens on its last clock, the stimulus that makes it so, and its run in
  /// lockstep.
  std::vector<std::string> what;
  Stimulus stimulus;
  Run run;
};
/// Asks it for so many seconds at the most, and checks a proof for ten more. InputError where there
/// is no yosys-abc.
FromResetAnswer asked_from_reset(const proof::FromReset& machine, proof::Happens what,
                                 const AnyBench& bench, std::chrono::seconds limit, unsigned jobs);

}  // namespace cosim::cli
