#include "tb/full/refuted.h"

#include <utility>

#include "tb/proof/explain.h"

namespace cosim::cli {

std::optional<Refuted> refuted(const proof::MachineFormula& formula, const AnyBench& bench,
                               const proof::Claim& claim, const proof::Decision& decision,
                               int limit) {
  if (claim.terms.empty()) return std::nullopt;
  auto found = proof::counterexample(formula, proof::refuting_values(claim, decision, limit));
  if (!found) return std::nullopt;
  Stimulus stimulus = proof::stimulus_of(*found, bench);
  Run run = bench.replay(stimulus);
  return Refuted{std::move(*found), std::move(stimulus), std::move(run)};
}

}  // namespace cosim::cli
