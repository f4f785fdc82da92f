// The check of lines beside the oracle, and on machines that are at fault.
#include <gtest/gtest.h>

#include <bit>

#include "model/linear/oracle.h"
#include "tb/designs/linear/figures.h"
#include "tb/designs/linear/sweeps.h"
#include "tests/designs/linear/records.h"
#include "tests/support/judged.h"

namespace cosim::linear {
namespace {

std::vector<Job> lines(const Params& p) { return test::drawn_jobs(random_line, p, 200); }

TEST(LinearChecker, PassesWhatTheOracleDraws) {
  for (const Params& p : {of(5, 2), of(8, 5), of(7, 1), of(32, 26)}) {
    const Sizes sizes = sizes_of(p);
    const auto all = lines(p);
    std::uint64_t steps = 0;
    double deviation = 0;
    for (const Job& job : all) {
      const std::int64_t whole = ticks(sizes.gamma(), job.line.major);
      // Input 17 is seen one word later.
      const std::int64_t drawn = job.words ? std::min(*job.words + 1, whole) : whole;
      for (std::int64_t k = 0; k < drawn; ++k) {
        steps += static_cast<std::uint64_t>(
            std::popcount(words_at(sizes.m, sizes.gamma(), job.line, k).major));
      }
      deviation = std::max(deviation,
                           linear::max_deviation(sizes.m, job.line.major, job.line.code).value());
    }
    test::expect_passes<Design, LineFigures>(p, all, steps, deviation);
  }
}

TEST(LinearChecker, SeesEveryWrongBit) {
  const Params p = of(6, 3);
  test::expect_faults_seen<Design, LineFigures>(
      p, lines(p), [](Outputs<Word>& outputs, std::uint64_t how) {
        auto out = named<Shown>(outputs);
        (how % 2 == 0 ? out.major : out.minor) ^= out.strobe << (how / 2 % 8);
        outputs = record_of<Outputs<Word>>(out);
        return out.strobe != 0;
      });
}

// A word more or less: of lines that are not given up.
TEST(LinearChecker, CountsTheWords) {
  const Params p = of(6, 3);
  auto all = lines(p);
  for (Job& job : all) job.words.reset();
  test::expect_faults_seen<Design, LineFigures>(p, all, [](Outputs<Word>& outputs, std::uint64_t) {
    auto out = named<Shown>(outputs);
    if (!out.busy) return false;
    out.strobe ^= 1;
    outputs = record_of<Outputs<Word>>(out);
    return true;
  });
}

}  // namespace
}  // namespace cosim::linear
