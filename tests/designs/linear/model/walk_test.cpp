// The oracle of lanes beside that of one line: it passes what the machine draws, sees what is not
// so and comes to the same figures.
#include "model/linear/checker.h"

#include <gtest/gtest.h>

#include "tb/designs/linear/check.h"
#include "tb/designs/linear/lanes.h"
#include "tb/designs/linear/sweeps.h"
#include "tests/support/walked.h"

namespace cosim::linear {
namespace {

std::vector<Job> lines(const Params& p, std::uint64_t count) {
  std::vector<Job> all;
  for (std::uint64_t i = 0; i < count; ++i) all.push_back(random_line(p, 1, i));
  return all;
}

TEST(LinearWalk, IsTheOracleOfOneLine) {
  for (const Params& p : {Params{5, 2}, Params{8, 5}, Params{7, 1}, Params{32, 26}}) {
    test::expect_same_oracle<Design, LineFigures>(p, lines(p, 200),
                                                  [&](auto all) { return Check(p, all); });
  }
}

TEST(LinearWalk, SeesWhatTheOracleOfOneLineSees) {
  const Params p{6, 3};
  test::expect_same_finds<Design, LineFigures>(
      p, lines(p, 200), [&](auto all) { return Check(p, all); },
      [&p](Outputs<Word>& out, std::uint64_t how) {
        if (how % 3 == 2) {
          out.strobe ^= 1;
        } else {
          (how % 3 == 0 ? out.major : out.minor) ^= Word{1} << (how / 3 % p.word());
        }
      });
}

}  // namespace
}  // namespace cosim::linear
