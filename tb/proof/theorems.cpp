#include "tb/proof/theorems.h"

#include <iterator>

namespace cosim::proof {

std::vector<Theorem> theorems() {
  std::vector<Theorem> all;
  for (auto* some : {circular_theorems, arc_theorems, code_theorems, word_theorems}) {
    std::vector<Theorem> list = some();
    std::move(list.begin(), list.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace cosim::proof
