// The check of lines beside the oracle, and on machines that are at fault.
#include "model/linear/checker.h"

#include <gtest/gtest.h>

#include <bit>

#include "model/linear/oracle.h"
#include "tb/designs/linear/figures.h"
#include "tb/designs/linear/sweeps.h"
#include "tests/support/judged.h"

namespace cosim::linear {
namespace {

std::vector<Job> lines(const Params& p) { return test::drawn_jobs(random_line, p, 200); }

TEST(LinearChecker, PassesWhatTheOracleDraws) {
  for (const Params& p : {Params{5, 2}, Params{8, 5}, Params{7, 1}, Params{32, 26}}) {
    const auto all = lines(p);
    std::uint64_t steps = 0;
    double deviation = 0;
    for (const Job& job : all) {
      const std::int64_t whole = ticks(p.gamma(), job.line.major);
      // Input 17 is seen one word later.
      const std::int64_t drawn = job.words ? std::min(*job.words + 1, whole) : whole;
      for (std::int64_t k = 0; k < drawn; ++k) {
        steps +=
            static_cast<std::uint64_t>(std::popcount(words_at(p.m, p.gamma(), job.line, k).major));
      }
      deviation =
          std::max(deviation, linear::max_deviation(p.m, job.line.major, job.line.code).value());
    }
    test::expect_passes<Design, LineFigures>(p, all, steps, deviation);
  }
}

TEST(LinearChecker, SeesEveryWrongBit) {
  const Params p{6, 3};
  test::expect_faults_seen<Design, LineFigures>(
      p, lines(p), [&p](Outputs<Word>& out, std::uint64_t how) {
        (how % 2 == 0 ? out.major : out.minor) ^= out.strobe << (how / 2 % p.word());
        return out.strobe != 0;
      });
}

// A word more or less: of lines that are not given up.
TEST(LinearChecker, CountsTheWords) {
  const Params p{6, 3};
  auto all = lines(p);
  for (Job& job : all) job.words.reset();
  test::expect_faults_seen<Design, LineFigures>(p, all, [](Outputs<Word>& out, std::uint64_t) {
    if (!out.busy) return false;
    out.strobe ^= 1;
    return true;
  });
}

}  // namespace
}  // namespace cosim::linear
