// What random transactions are, counted.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tb/stream/bench.h"
#include "tb/util/show.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

constexpr std::uint64_t wanted = 10000;  // transactions of each stream, at least
constexpr std::size_t most_shown = 64;   // values of a field

// "lw 4.1 %, sw 4.0 %", by the values; of more only how many there are, and the most frequent.
std::string shares_text(const Field& field, const std::map<Word, std::uint64_t>& counts,
                        std::uint64_t all) {
  std::vector<std::pair<Word, std::uint64_t>> shown(counts.begin(), counts.end());
  std::string more;
  if (shown.size() > most_shown) {
    std::ranges::stable_sort(shown,
                             [](const auto& a, const auto& b) { return a.second > b.second; });
    more = fmt::format("{} values, most often ", shown.size());
    shown.resize(8);
  }
  std::vector<std::string> shares;
  for (const auto& [value, hits] : shown) {
    shares.push_back(fmt::format("{} {:.1f} %", show_short(field, value),
                                 100.0 * static_cast<double>(hits) / static_cast<double>(all)));
  }
  return fmt::format("{}{}", more, fmt::join(shares, ", "));
}

}  // namespace

std::string AnyStreamBench::drawn_text(std::uint64_t seed) const {
  std::vector<std::vector<std::map<Word, std::uint64_t>>> counts;  // by stream and cell
  for (const Interface& i : shape_.in) counts.emplace_back(i.cells.size());
  std::vector<std::uint64_t> drawn(shape_.in.size());
  std::uint64_t cases = 0;
  while (std::ranges::any_of(drawn, [](std::uint64_t n) { return n < wanted; })) {
    StreamCase one(shape_);
    draw_stream_case(shape_, seed, cases++, shape_.most_transactions, may_go(), one);
    for (std::size_t s = 0; s < drawn.size(); ++s) {
      drawn[s] += one.given[s].size();
      for (std::size_t n = 0; n < one.given[s].size(); ++n) {
        for (std::size_t c = 0; c < counts[s].size(); ++c) ++counts[s][c][one.given[s][n][c]];
      }
    }
  }
  std::string text;
  for (std::size_t s = 0; s < drawn.size(); ++s) {
    const Interface& i = shape_.in[s];
    text += fmt::format("{}: {} in {}, seed {}\n", i.name, count(drawn[s], "transaction"),
                        count(cases, "case"), seed);
    for (std::size_t c = 0; c < i.cells.size(); ++c) {
      text += fmt::format("  {}: {}\n", label_of(i.cells[c]),
                          shares_text(i.cells[c], counts[s][c], drawn[s]));
    }
  }
  return text;
}

}  // namespace cosim
