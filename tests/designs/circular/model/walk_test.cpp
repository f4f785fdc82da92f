// The oracle of lanes beside that of one arc: it passes what the machine draws, sees what is not so
// and comes to the same figures.
#include "model/circular/checker.h"

#include <gtest/gtest.h>

#include "tb/designs/circular/check.h"
#include "tb/designs/circular/lanes.h"
#include "tb/designs/circular/sweeps.h"
#include "tests/support/walked.h"

namespace cosim::circular {
namespace {

std::vector<Arc> arcs(const Params& p, std::uint64_t count) {
  std::vector<Arc> all;
  for (std::uint64_t i = 0; i < count; ++i) all.push_back(random_arc(p, 1, i));
  for (const Point& from : every_start(225)) all.push_back({from, 225, {}});
  if (p.width < 4) all.resize(count);
  return all;
}

TEST(CircularWalk, IsTheOracleOfOneArc) {
  for (const int width : {2, 4, 8, 32}) {
    const Params p{width};
    test::expect_same_oracle<Design, ArcFigures>(p, arcs(p, 200),
                                                 [&](auto all) { return Check(all); });
  }
}

TEST(CircularWalk, SeesWhatTheOracleOfOneArcSees) {
  const Params p{6};
  test::expect_same_finds<Design, ArcFigures>(
      p, arcs(p, 200), [&](auto all) { return Check(all); },
      [](Outputs<Word>& out, std::uint64_t how) { (how % 2 == 0 ? out.step_x : out.step_y) ^= 1; });
}

}  // namespace
}  // namespace cosim::circular
