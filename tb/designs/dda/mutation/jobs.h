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
    const int width = dda::width_of(p);
    return {
        dda::line(width, {27, 9}, {}),
        dda::arc(width, {12, 0}, {0, 12}, {dda::Update::sequential, dda::Preload::half, false})};
  }
  static List random(const dda::Params& p, std::uint64_t seed, std::uint64_t i) {
    return {dda::random_job(dda::width_of(p), seed, i)};
  }
  /// The first clocks of lines that show each digit of a word, each in its turn: of those down and
  /// to the left whose rate is full but for the digit, what such a rate is taken for; of those with
  /// the digit alone as the steps left, whether steps are left. Behind them a line as long as there
  /// is, so that the steps left go through all their digits: nothing comes behind it in time.
  static List longest(const dda::Params& p, std::uint64_t, std::uint64_t i) {
    const int width = dda::width_of(p);
    List lines;
    const auto begin = [&](const dda::Point& to) {
      lines.push_back(dda::line(width, to, {}));
      lines.back().clocks = 4 * width;
    };
    for (int digit = static_cast<int>(i); digit < width; digit += long_jobs) {
      const std::int64_t alone = shift_left(1, digit);
      begin({alone, alone});
      if (digit == width - 1) continue;
      const std::int64_t nearly = shift_left(1, width - 1) - alone;
      begin({1, -nearly});
      begin({-nearly, 1});
    }
    const std::int64_t most = ones(width) - static_cast<std::int64_t>(i);
    lines.push_back(dda::line(width, {most, -most}, {}));
    return lines;
  }
};

}  // namespace cosim::mutation
