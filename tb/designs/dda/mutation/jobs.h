// Curves for mutants of the DDA.
#pragma once

#include "tb/designs/dda/sweeps.h"
#include "tb/mutation/cases.h"

namespace cosim::mutation {

template <>
struct Jobs<dda::Design> {
  using List = std::vector<dda::Job>;

  /// The line of the linear source and the circle of the circular one.
  static List printed(const dda::Params& p) {
    return {dda::line(p, {27, 9}, {}),
            dda::arc(p, {12, 0}, {0, 12}, {dda::Update::sequential, dda::Preload::half, false})};
  }
  static List random(const dda::Params& p, std::uint64_t seed, std::uint64_t i) {
    return {dda::random_job(p, seed, i)};
  }
  /// Lines as long as there are, so that the steps left go through all their digits; and the first
  /// clocks of lines down and to the left whose rate is full but for one digit, each in its turn:
  /// what such a rate is taken for shows there.
  static List longest(const dda::Params& p, std::uint64_t, std::uint64_t i) {
    const std::int64_t most = ones(p.width) - static_cast<std::int64_t>(i);
    List lines{dda::line(p, {most, -most}, {})};
    for (int digit = static_cast<int>(i); digit < p.width - 1; digit += long_jobs) {
      const std::int64_t nearly = shift_left(1, p.width - 1) - shift_left(1, digit);
      for (const dda::Point to : {dda::Point{1, -nearly}, dda::Point{-nearly, 1}}) {
        lines.push_back(dda::line(p, to, {}));
        lines.back().clocks = 4 * p.width;
      }
    }
    return lines;
  }
};

}  // namespace cosim::mutation
