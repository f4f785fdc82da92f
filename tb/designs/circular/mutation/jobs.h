// Arcs for mutants of the circular machine.
#pragma once

#include <algorithm>

#include "model/circular/oracle.h"
#include "tb/designs/circular/sweeps.h"
#include "tb/mutation/cases.h"

namespace cosim::mutation {

template <>
struct Jobs<circular::Design> {
  using List = std::vector<circular::Arc>;

  /// The source's R = 12.
  static List printed(const circular::Params&) { return {{{12, 0}, 144, {}}}; }
  static List random(const circular::Params& p, std::uint64_t seed, std::uint64_t i) {
    return {circular::random_arc(circular::width_of(p), seed, i)};
  }
  /// The first steps of arcs that change their sector near (2^k, 2^k), each k in its turn: there
  /// counter 7 holds a single bit, or nearly, while it is corrected. Then a quarter circle as large
  /// as there is.
  static List longest(const circular::Params& p, std::uint64_t, std::uint64_t i) {
    const int width = circular::width_of(p);
    const std::int64_t most = ones(width);
    List arcs;
    for (int digit = static_cast<int>(i); digit < width; digit += long_jobs) {
      const std::int64_t power = shift_left(1, digit);
      for (std::int64_t x = power + 1; x <= power + 4; ++x) {
        for (std::int64_t y = std::max<std::int64_t>(power - 2, 0); y <= power + 1; ++y) {
          const std::uint64_t radius2 = square(x) + square(y);
          if (circular::nearest_root(radius2) <= most) arcs.push_back({{x, y}, radius2, 8});
        }
      }
    }
    const std::int64_t r = most - static_cast<std::int64_t>(i);
    arcs.push_back({{r, 0}, square(r), {}});
    return arcs;
  }

 private:
  static std::uint64_t square(std::int64_t v) {
    return static_cast<std::uint64_t>(v) * static_cast<std::uint64_t>(v);
  }
};

}  // namespace cosim::mutation
