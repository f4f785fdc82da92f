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
    const int m = linear::sizes_of(p).m;
    return {{{shift_left(27, m - 5), static_cast<linear::Code>(shift_left(10, m - 5))}, {}}};
  }
  static List random(const linear::Params& p, std::uint64_t seed, std::uint64_t i) {
    return {linear::random_line(p, seed, i)};
  }
  /// Nearly as long as there are, so that the deepest carries of the counters run. The codes tell
  /// every digit of the code from every other, in both directions: its lowest digit alone, all
  /// digits, and for each digit of a digit's number those where it is 1, then those where it is 0.
  static List longest(const linear::Params& p, std::uint64_t, std::uint64_t i) {
    const Word most = ones(linear::sizes_of(p).m);
    linear::Code code = i == 0 ? 1 : ~linear::Code{0};
    if (i > 1) {
      code = 0;
      for (std::uint64_t digit = 0; digit < 64; ++digit) {
        const std::uint64_t of_number = digit >> (i / 2 - 1) & 1;
        code |= static_cast<linear::Code>(of_number ^ (i & 1)) << digit;
      }
    }
    code &= static_cast<linear::Code>(most);
    return {{{most - static_cast<Word>(i), code}, {}}};
  }
};

}  // namespace cosim::mutation
