#include "tb/proof/theorems.h"

#include <iterator>

namespace cosim::proof {

std::vector<Theorem> joined(std::vector<std::vector<Theorem>> lists) {
  std::vector<Theorem> all;
  for (auto& list : lists) std::move(list.begin(), list.end(), std::back_inserter(all));
  return all;
}

}  // namespace cosim::proof
