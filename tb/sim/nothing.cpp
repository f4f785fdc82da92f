// Whether a run that matches has compared anything.
#include <fmt/core.h>

#include <algorithm>

#include "tb/sim/report.h"

namespace cosim {

std::string streams_text(const AnyBench& bench, const std::vector<Transactions>& all) {
  std::string text;
  for (std::size_t s = 0; s < all.size(); ++s) {
    const auto& [name, goes_in] = bench.streams()[s];
    text += fmt::format("{}{}: {} {}", s == 0 ? "" : "; ", name, all[s].moved,
                        goes_in ? "in" : fmt::format("out, {} compared", all[s].compared));
  }
  return text;
}

bool compared_nothing(const Outcome& o) {
  const Result& r = o.result;
  if (!r.match()) return false;
  if (!o.bench->streams().empty()) {
    return std::ranges::all_of(r.streams, [](const Transactions& s) { return s.compared == 0; });
  }
  const auto never = [&](std::uint64_t left_out) { return left_out == r.clocks; };
  return r.clocks == 0 || (!r.left_out.empty() && std::ranges::all_of(r.left_out, never));
}

std::string nothing_text(const Outcome& o, const std::string& option) {
  const bool has_streams = !o.bench->streams().empty();
  return fmt::format("{}: nothing was compared: {}; {} makes that no error", o.bench->title(),
                     has_streams            ? streams_text(*o.bench, o.result.streams)
                     : o.result.clocks == 0 ? "there was no clock"
                                            : "compared() was false on every clock",
                     option);
}

}  // namespace cosim
