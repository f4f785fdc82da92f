// The oracle of lanes beside that of one job: it passes what the machine draws, sees what is not so
// and comes to the same figures.
#include "model/dda/checker.h"

#include <gtest/gtest.h>

#include "tb/designs/dda/check.h"
#include "tb/designs/dda/lanes.h"
#include "tb/designs/dda/sweeps.h"
#include "tests/support/walked.h"

namespace cosim::dda {
namespace {

std::vector<Job> jobs(const Params& p, int count) {
  std::vector<Job> all;
  for (std::uint64_t i = 0; all.size() < static_cast<std::size_t>(count); ++i) {
    Job job = random_job(p, 1, i);
    const State<Word>& s = job.start;
    // Of other curves it knows no deviation.
    if (s.b != 0 || s.two_a != s.two_c) continue;
    job.start.normalise = job.start.two_a == 0 ? i & 1 : 0;
    all.push_back(job);
  }
  return all;
}

TEST(DdaWalk, IsTheOracleOfOneJob) {
  for (const int width : {3, 6, 10, 32}) {
    const Params p{width};
    test::expect_same_oracle<Design, CurveFigures>(p, jobs(p, 200),
                                                   [&](auto all) { return Check(p, all); });
  }
}

TEST(DdaWalk, SeesWhatTheOracleOfOneJobSees) {
  const Params p{6};
  test::expect_same_finds<Design, CurveFigures>(
      p, jobs(p, 100), [&](auto all) { return Check(p, all); },
      [](Outputs<Word>& out, std::uint64_t how) {
        Word* pins[] = {&out.x_up, &out.x_down, &out.y_up, &out.y_down};
        if (how % 5 == 4) {
          out.code_x ^= 1;
        } else {
          *pins[how % 5] ^= 1;
        }
      });
}

}  // namespace
}  // namespace cosim::dda
