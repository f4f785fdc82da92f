// A claim that an engine refuted, run in lockstep.
#pragma once

#include <optional>

#include "tb/bench/bench.h"
#include "tb/proof/counterexample.h"
#include "tb/proof/decide.h"

namespace cosim::cli {

/// What a failure folder calls the case.
inline constexpr const char* refuted_case = "counterexample of the proof";

struct Refuted {
  proof::Counterexample counterexample;
  Stimulus stimulus;
  Run run;  ///< of the stimulus; it matches where the RTL of the claim is not the bench's
};
/// The counterexample of a claim on `formula`, the machine of `bench`; none where the claim was not
/// refuted, or no engine shows the values.
std::optional<Refuted> refuted(const proof::MachineFormula& formula, const AnyBench& bench,
                               const proof::Claim& claim, const proof::Decision& decision,
                               int limit);

}  // namespace cosim::cli
