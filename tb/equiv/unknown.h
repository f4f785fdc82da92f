// What the old RTL leaves x, as values.
#pragma once

#include <set>
#include <vector>

#include "tb/equiv/product.h"
#include "tb/proof/reach.h"

namespace cosim::equiv {

/// All 0, all 1, and some by chance, so that what depends on several bits is seen to.
std::vector<Filler> first_fillers(std::size_t bits);

/// What is certain of the outputs that differ at the end of a stimulus.
struct Certain {
  bool any = false;            ///< one of them is the same with every value of the old RTL's x
  std::set<Name> open;         ///< those that are not, or of which it is not known
  std::vector<Filler> others;  ///< values with which one of `open` is another
};
Certain certain_of(const Question& question, const Product& product, const proof::Reached& reached);

}  // namespace cosim::equiv
