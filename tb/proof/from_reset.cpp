#include "tb/proof/from_reset.h"

#include "tb/nets/runs.h"

namespace cosim::proof {
namespace {}

FromReset::FromReset(const nets::Model& model, const RtlNets& rtl,
                     const std::map<std::string, Word>& tied, const std::vector<Watched>& watched)
    : product_(product_of(model, rtl, tied, watched)) {}

std::vector<std::vector<Word>> FromReset::words_of(
    const std::vector<std::vector<bool>>& inputs) const {
  nets::Bits bits;
  for (const auto& input : product_.inputs) bits.insert(bits.end(), input.begin(), input.end());
  std::vector<std::vector<Word>> clocks;
  for (const auto& row : nets::traced(product_.graph, inputs, bits)) {
    auto& words = clocks.emplace_back();
    std::size_t bit = 0;
    for (const auto& input : product_.inputs) {
      Word& word = words.emplace_back();
      for (std::size_t b = 0; b < input.size(); ++b) word |= Word{row[bit++]} << b;
    }
  }
  return clocks;
}

FromReset::Any FromReset::any_of(Happens what) const {
  Any any{product_.graph};
  for (const auto& [name, lit] : product_.asked.at(what)) any.bad = any.graph.or_of(any.bad, lit);
  return any;
}

HappensFromReset FromReset::ask(Happens what, std::chrono::steady_clock::time_point until,
                                unsigned jobs) const {
  HappensFromReset all;
  if (!product_.asked.contains(what)) {
    all.reached = {Ever::never, "nothing to be asked", {}, false, 0};
    return all;
  }
  const Any any = any_of(what);
  all.reached = reach(any.graph, any.bad, until, jobs);
  if (all.reached.ever != Ever::yes) return all;
  all.clocks = words_of(all.reached.inputs);
  nets::Bits each;
  for (const auto& [name, lit] : product_.asked.at(what)) each.push_back(lit);
  const auto last = nets::traced(any.graph, all.reached.inputs, each).back();
  for (std::size_t i = 0; i < each.size(); ++i) {
    if (last[i]) all.what.push_back(product_.asked.at(what)[i].first);
  }
  return all;
}

Invariant FromReset::check(Happens what, std::chrono::steady_clock::time_point until) const {
  const Any any = any_of(what);
  return invariant_of(any.graph, any.bad, until);
}

WatchedFromReset FromReset::ask_watched(std::chrono::steady_clock::time_point until, unsigned jobs,
                                        const std::function<void(std::size_t)>& left) const {
  nets::Bits each;
  if (const auto at = product_.asked.find(Happens::watched); at != product_.asked.end()) {
    for (const auto& [name, lit] : at->second) each.push_back(lit);
  }
  const ReachedEach reached = reach_each(product_.graph, each, until, jobs, left);
  WatchedFromReset all{reached.points, {}};
  for (const auto& inputs : reached.stimuli) all.stimuli.push_back(words_of(inputs));
  return all;
}

}  // namespace cosim::proof
