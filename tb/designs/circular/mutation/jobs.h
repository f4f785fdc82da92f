// Arcs for mutants of the circular machine.
#pragma once

#include "tb/designs/circular/sweeps.h"
#include "tb/mutation/cases.h"

namespace cosim::mutation {

template <>
struct Jobs<circular::Design> {
  using List = std::vector<circular::Arc>;

  /// The source's R = 12.
  static List printed(const circular::Params&) { return {{{12, 0}, 144, {}}}; }
  static List random(const circular::Params& p, std::uint64_t seed, std::uint64_t i) {
    return {circular::random_arc(p, seed, i)};
  }
  /// Quarter circles as large as there are.
  static List longest(const circular::Params& p, std::uint64_t, std::uint64_t i) {
    const std::int64_t r = ones(p.width) - static_cast<std::int64_t>(i);
    return {{{r, 0}, static_cast<std::uint64_t>(r) * static_cast<std::uint64_t>(r), {}}};
  }
};

}  // namespace cosim::mutation
