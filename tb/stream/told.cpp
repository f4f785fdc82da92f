// What is wrong, in words of the design's own.
#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tb/stream/bench.h"

namespace cosim {

std::vector<std::string> AnyStreamBench::told(const StreamFinding& finding,
                                              const StreamOrder& order, const Sequence& came,
                                              const std::vector<std::size_t>& taken) const {
  constexpr std::size_t most = 4;  // transactions of a stream
  std::vector<std::string> lines;
  const auto add = [&](const std::string& what, const Interface& i, const Sequence& all,
                       std::size_t n) {
    if (n >= all.size() || !i.text) return;
    lines.push_back(fmt::format("{}{} number {}: {}", what, i.name, n, i.text(all[n])));
  };
  std::vector<Sequence> gone;
  for (std::size_t s = 0; s < taken.size(); ++s) {
    const Sequence& given = order.given.given[s];
    for (std::size_t n = taken[s] - std::min(taken[s], most); n < taken[s]; ++n) {
      add("", shape_.in[s], given, n);
    }
    gone.emplace_back(given.cells());
    for (std::size_t n = 0; n < taken[s]; ++n) gone.back().push(given[n]);
  }
  if (!finding.goes_in) {
    const Interface& out = shape_.out[finding.stream];
    add("expected ", out, order.expected[finding.stream], finding.number);
    add("actual   ", out, came, finding.number);
  }
  const std::string state = gone.empty() ? "" : state_after(gone);
  if (!state.empty()) lines.push_back("the model behind these: " + state);
  return lines;
}

}  // namespace cosim
