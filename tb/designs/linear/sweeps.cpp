#include "tb/designs/linear/sweeps.h"

#include <fmt/core.h>

#include "model/linear/control_code.h"
#include "model/linear/oracle.h"
#include "tb/designs/linear/figures.h"
#include "tb/sim/drawn_sweep.h"

namespace cosim::linear {

Sweep every_line(const LinearBench& bench) {
  const int m = sizes_of(bench.params()).m;
  const auto lines_of = [m](std::uint64_t major) {
    return [major = static_cast<std::int64_t>(major), codes = Code{1} << m,
            code = Code{0}](Job& job) mutable {
      job = {{major, code}, {}};
      return code++ < codes;
    };
  };
  return drawn_sweep<LineFigures>(
      bench, "every BP with every UK", std::uint64_t{1} << m, lines_of, 1,
      [](std::uint64_t major) { return fmt::format("BP = {} with every UK", major); });
}

Job random_line(const Params& p, std::uint64_t seed, std::uint64_t i) {
  const Sizes sizes = sizes_of(p);
  constexpr std::int64_t longest = 2000;
  Random random = Random::for_case(seed, i);
  Job job;
  job.line.major = random.corner(sizes.m);
  job.line.code = random.one_in_power(2)
                      ? best_code(sizes.m, job.line.major,
                                  static_cast<std::int64_t>(
                                      random.below(static_cast<std::uint64_t>(job.line.major) + 1)))
                      : static_cast<Code>(random.corner(sizes.m));
  if (ticks(sizes.gamma(), job.line.major) > longest) {
    job.words = static_cast<std::int64_t>(random.below(longest));
  }
  return job;
}

Sweep random_lines(const LinearBench& bench, std::uint64_t seed, std::uint64_t count) {
  const Params p = bench.params();
  return drawn_sweep_of_one<LineFigures>(
      bench, "random lines", count, [=](std::uint64_t i) { return random_line(p, seed, i); },
      [=](const Job& job) {
        return fmt::format("BP = {}, UK = {:0{}b}, seed {}", job.line.major, job.line.code,
                           sizes_of(p).m, seed);
      });
}

}  // namespace cosim::linear
