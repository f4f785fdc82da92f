// The claims of mutants.h as questions on nets.
#pragma once

#include <vector>

#include "tb/proof/net_questions.h"

namespace cosim::proof {

/// What reached_claim() says.
NetQuestions nets_of_reached(const nets::Model& model);

struct MutantNets {
  enum class Known { same, other, asked };
  std::vector<Known> known;  ///< of each mutant, where nothing has to be asked
  NetQuestions questions;    ///< a bit for each of the others, in their order
};

/// Whether each of these mutants is another machine than the RTL without one: both in one graph,
/// with the registers of both holding what the model's hold. `rtl` has the input mutsel. InputError
/// where its nets are not those of the tables.
MutantNets nets_of_mutants(const nets::Model& model, const RtlNets& rtl,
                           const std::vector<unsigned>& numbers);

}  // namespace cosim::proof
