// Lines for mutants of the linear machine.
#pragma once

#include "tb/designs/linear/sweeps.h"
#include "tb/mutation/cases.h"

namespace cosim::mutation {

template <>
struct Jobs<linear::Design> {
  using List = std::vector<linear::Job>;

  /// BP = 27, UK = 01010 of the source; in wider machines the same leading bits of both.
  static List printed(const linear::Params& p) {
    return {{{shift_left(27, p.m - 5), static_cast<linear::Code>(shift_left(10, p.m - 5))}, {}}};
  }
  static List random(const linear::Params& p, std::uint64_t seed, std::uint64_t i) {
    return {linear::random_line(p, seed, i)};
  }
  /// Nearly as long as there are, so that the deepest carries of the counters run; the codes at
  /// random but for their last bits, which choose among the rarest steps.
  static List longest(const linear::Params& p, std::uint64_t seed, std::uint64_t i) {
    Random random = Random::for_case(seed, i);
    const linear::Code code = random.next() & static_cast<linear::Code>(ones(p.m));
    return {{{ones(p.m) - static_cast<Word>(i), i == 0 ? linear::Code{1} : code}, {}}};
  }
};

}  // namespace cosim::mutation
