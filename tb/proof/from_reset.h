// Model and RTL side by side from their reset on, as one graph with registers: what can ever happen
// there is asked of reach.h. The two need not have the same registers.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tb/proof/invariant.h"
#include "tb/proof/product.h"
#include "tb/proof/reach.h"
#include "tb/proof/reach_each.h"

namespace cosim::proof {

struct HappensFromReset {
  Reached reached;
  /// Of yes: the inputs of each clock after the reset, in the order of their table, and what it is
  /// that happens on the last one, a few words each.
  std::vector<std::vector<Word>> clocks;
  std::vector<std::string> what;
};

/// What came of each that is watched, and the inputs of each clock after the reset of each
/// stimulus, in the order of their table.
struct WatchedFromReset {
  std::vector<ReachedEach::Point> points;
  std::vector<std::vector<std::vector<Word>>> stimuli;
};

/// A clock that is assumed not to have legal inputs, and all that come after it, are left out.
class FromReset {
 public:
  /// `tied`: inputs of the RTL that are no inputs of the model, by their ports, and what they are;
  /// of others any value is tried. InputError where the RTL lacks what a table names.
  FromReset(const nets::Model& model, const RtlNets& rtl,
            const std::map<std::string, Word>& tied = {}, const std::vector<Watched>& watched = {});

  /// Ends when it is `until`. InputError as of reach().
  HappensFromReset ask(Happens what, std::chrono::steady_clock::time_point until,
                       unsigned jobs) const;
  /// Of what never happens: looks for a proof that other engines find and a solver checks, until
  /// then.
  Invariant check(Happens what, std::chrono::steady_clock::time_point until) const;
  /// Each that is watched, as of reach_each().
  WatchedFromReset ask_watched(std::chrono::steady_clock::time_point until, unsigned jobs,
                               const std::function<void(std::size_t)>& left) const;

 private:
  struct Any {
    nets::Graph graph;
    nets::Bit bad = nets::no;
  };
  Any any_of(Happens what) const;
  std::vector<std::vector<Word>> words_of(const std::vector<std::vector<bool>>& inputs) const;

  Product product_;
};

}  // namespace cosim::proof
