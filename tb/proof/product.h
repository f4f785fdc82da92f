// The product of model and RTL: one graph in which both work side by side from their reset on,
// given the same inputs. The two need not have the same registers.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tb/nets/graph.h"
#include "tb/nets/model.h"
#include "tb/proof/rtl_nets.h"

namespace cosim::proof {

/// What may be asked of a machine from its reset on.
enum class Happens {
  differ,     ///< a register or an output that is compared differs, or the invariant is broken
  stuck,      ///< no input is legal, although the model says which are
  assertion,  ///< what the RTL asserts is not so
  watched,    ///< one of what FromReset was given to watch
};

/// Something that a clock may have.
struct Watched {
  nets::Bits toggles = {};      ///< of the RTL: one is not what it was a clock before
  nets::Bits holds = {};        ///< of the RTL: one is 1
  std::string model_case = {};  ///< of the model's cases or ways, by its name: it is so
};

struct Product {
  nets::Graph graph;
  std::vector<nets::Bits> inputs;  ///< of the model, lowest bit first
  std::map<Happens, std::vector<std::pair<std::string, nets::Bit>>> asked;
};

/// `tied`: inputs of the RTL that are no inputs of the model, by their ports, and what they are;
/// any other is free. InputError where the RTL lacks what a table names.
Product product_of(const nets::Model& model, const RtlNets& rtl,
                   const std::map<std::string, Word>& tied, const std::vector<Watched>& watched);

}  // namespace cosim::proof
