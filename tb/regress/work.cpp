#include "tb/regress/work.h"

#include <algorithm>
#include <stdexcept>

namespace cosim::regress {

const Kind& kind_of(const Kinds& kinds, const Task& task) {
  const auto found =
      std::ranges::find_if(kinds, [&](const auto& kind) { return kind->keys().kind == task.kind; });
  if (found == kinds.end()) throw std::logic_error(task.kind + ": no kind of task");
  return **found;
}

std::vector<Keys> keys_of(const Kinds& kinds) {
  std::vector<Keys> all;
  for (const auto& kind : kinds) all.push_back(kind->keys());
  return all;
}

}  // namespace cosim::regress
