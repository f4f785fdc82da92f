// Curves for mutants of the DDA.
#pragma once

#include "tb/dda_sweeps.h"
#include "tests/mutation/cases.h"

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
  /// Lines as long as there are, so that the steps left go through all their digits.
  static List longest(const dda::Params& p, std::uint64_t, std::uint64_t i) {
    const std::int64_t most = ones(p.width) - static_cast<std::int64_t>(i);
    return {dda::line(p, {most, -most}, {})};
  }
};

}  // namespace cosim::mutation
