// Model and RTL side by side from their reset on, as one graph with registers: what can ever happen
// there is asked of reach.h. The two need not have the same registers.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tb/nets/model.h"
#include "tb/proof/reach.h"
#include "tb/proof/reach_each.h"
#include "tb/proof/rtl_nets.h"

namespace cosim::proof {

/// What may be asked of a machine from its reset on.
enum class Happens {
  differ,     ///< a register or an output that is compared differs, or the invariant is broken
  stuck,      ///< no input is legal, although the model says which are
  assertion,  ///< what the RTL asserts is not so
  watched,    ///< one of what FromReset was given to watch
};

/// Something that a clock may have.
struct Watched {
  std::vector<std::size_t> toggles =
      {};                               ///< nets of the RTL: one is not what it was a clock before
  std::vector<std::size_t> holds = {};  ///< nets of the RTL: one is 1
  std::string model_case = {};          ///< of the model's cases, by its name: it is so
};

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
  /// Each that is watched, as of reach_each().
  WatchedFromReset ask_watched(std::chrono::steady_clock::time_point until, unsigned jobs,
                               const std::function<void(std::size_t)>& left) const;

  struct Product {
    Aig graph;
    std::vector<std::vector<Aig::Lit>> inputs;  ///< of the model, lowest bit first
    std::map<Happens, std::vector<std::pair<std::string, Aig::Lit>>> asked;
  };

 private:
  std::vector<std::vector<Word>> words_of(const std::vector<std::vector<bool>>& inputs) const;

  Product product_;
};

}  // namespace cosim::proof
