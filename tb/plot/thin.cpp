#include "tb/plot/thin.h"

#include <algorithm>
#include <map>

namespace cosim {

std::vector<Mark> worst_of_cells(const std::vector<Mark>& marks, const Cell& cell) {
  std::map<std::pair<std::int64_t, std::int64_t>, Mark> worst;
  for (const Mark& mark : marks) {
    const auto [at, added] = worst.try_emplace(cell(mark), mark);
    if (!added && mark.off > at->second.off) at->second = mark;
  }
  std::vector<Mark> kept;
  kept.reserve(worst.size());
  for (const auto& [key, mark] : worst) kept.push_back(mark);
  std::stable_sort(kept.begin(), kept.end(),
                   [](const Mark& a, const Mark& b) { return a.off < b.off; });
  return kept;
}

}  // namespace cosim
