// The check of arcs beside the oracle, and on machines that are at fault.
#include <gtest/gtest.h>

#include "tb/designs/circular/figures.h"
#include "tb/designs/circular/sweeps.h"
#include "tests/designs/circular/records.h"
#include "tests/support/judged.h"

namespace cosim::circular {
namespace {

std::vector<Arc> arcs(int width, std::uint64_t count) {
  auto all = test::drawn_jobs(random_arc, width, count);
  for (const Point& from : every_start(225)) all.push_back({from, 225, {}});
  if (width < 4) all.resize(count);
  return all;
}

TEST(CircularChecker, PassesWhatTheOracleDraws) {
  for (const int width : {2, 4, 8, 32}) {
    const auto all = arcs(width, 200);
    std::uint64_t steps = 0;
    double deviation = 0;
    for (const Arc& arc : all) {
      Point at = arc.from;
      const std::int64_t whole = steps_to_end(arc.from, arc.radius2);
      for (std::int64_t left = std::min(arc.count.value_or(whole), whole);; --left, ++steps) {
        deviation = std::max(deviation, radial_deviation(at, arc.radius2));
        if (left == 0) break;
        at = next_point(at, arc.radius2);
      }
    }
    test::expect_passes<Design, ArcFigures>(of_width(width), all, steps, deviation);
  }
}

TEST(CircularChecker, SeesEveryWrongStep) {
  test::expect_faults_seen<Design, ArcFigures>(
      of_width(6), arcs(6, 200), [](Outputs<Word>& outputs, std::uint64_t how) {
        auto out = named<Shown>(outputs);
        (how % 2 == 0 ? out.step_x : out.step_y) ^= out.running;
        outputs = record_of<Outputs<Word>>(out);
        return out.running != 0;
      });
}

// R = 12, the source's example, shown step by step: | up, - left, / both, = none.
std::string said_of(const std::vector<std::string>& drawn) {
  const std::vector<Arc> list = {{{12, 0}, 144, {}}, {{8, 9}, 144, {}}, {{12, 0}, 144, 3}};
  JobCheck<Design, ArcFigures> check(of_width(4), list);
  for (std::size_t job = 0; job < drawn.size(); ++job) {
    for (const char c : '=' + drawn[job] + '=') {
      Compared<Design> seen{};
      seen.outputs = record_of<Outputs<Word>>(Shown{1, c == '|' || c == '/', c == '-' || c == '/'});
      check.clock(job, seen);
    }
    check.clock(job, {});
  }
  return check.so_far().error;
}

TEST(CircularChecker, CountsTheStepsAndNamesTheClock) {
  const std::vector<std::string> right = {"|||/|/|//=/-/-/---", "/-/-/---", "|||"};
  EXPECT_EQ(said_of(right), "");
  EXPECT_NE(said_of({right[0], "/-/-/--"}), "");
  EXPECT_NE(said_of({right[0], "/-/-/----"}), "");
  EXPECT_NE(said_of({right[0], right[1], "||"}), "");
  EXPECT_NE(said_of({right[0], right[1], "|||/"}), "");
  const std::string said = said_of({"|/"});
  EXPECT_EQ(said.substr(0, said.find(':')), "R^2 = 144 from (12, 0), clock 2");
}

}  // namespace
}  // namespace cosim::circular
