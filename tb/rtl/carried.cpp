#include "tb/rtl/carried.h"

#include <deque>

namespace cosim::rtl {

std::map<std::string, long> Carried::carriers(const std::string& net) const {
  std::map<std::string, long> seen;
  for (std::deque<std::pair<std::string, long>> left{{net, 0}}; !left.empty(); left.pop_front()) {
    const auto [next, low] = left.front();
    if (!seen.try_emplace(next, low).second) continue;
    const auto to = carries_.find(next);
    if (to == carries_.end()) continue;
    for (const auto& [other, at] : to->second) left.emplace_back(other, low + at);
  }
  return seen;
}

Carried::Reach Carried::reach(const std::string& net) const {
  Reach all;
  for (std::deque<std::pair<std::string, bool>> left{{net, false}}; !left.empty();
       left.pop_front()) {
    const auto [next, is_inverse] = left.front();
    if (!(is_inverse ? all.inverse : all.same).insert(next).second) continue;
    if (const auto to = carries_.find(next); to != carries_.end()) {
      for (const auto& [other, low] : to->second) left.emplace_back(other, is_inverse);
    }
    if (const auto to = inverts_.find(next); to != inverts_.end()) {
      for (const std::string& other : to->second) left.emplace_back(other, !is_inverse);
    }
  }
  return all;
}

}  // namespace cosim::rtl
