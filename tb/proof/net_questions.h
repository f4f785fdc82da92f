// What is claimed of a machine, as questions on nets: the model and the RTL in one graph, its
// inputs and the state free, and bits of it that must never hold. The claims are those of claims.h;
// what is assumed is part of each bit that is asked.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tb/nets/blif.h"
#include "tb/nets/model.h"
#include "tb/proof/rtl_nets.h"

namespace cosim::proof {

/// Can a bit of a graph be true?
struct NetQuestions {
  nets::Graph graph;
  std::vector<nets::Port> inputs;  ///< its free bits
  std::vector<nets::Port> asked;   ///< each bit with a few words
  /// The codes of what a counterexample shows, lowest bit first, by the terms that Claim::terms
  /// has.
  std::map<std::string, std::vector<nets::Bit>> terms;
};

/// InputError where the RTL's flip-flops are not those of the tables, one for one.
NetQuestions nets_of_base_case(const nets::Model& model, const RtlNets& rtl);
NetQuestions nets_of_step(const nets::Model& model, const RtlNets& rtl);
NetQuestions nets_of_cases(const nets::Model& model);
NetQuestions nets_of_legal(const nets::Model& model);

}  // namespace cosim::proof
