// The check of curves beside the oracle, and on machines that are at fault.
#include <gtest/gtest.h>

#include "model/dda/oracle.h"
#include "tb/designs/dda/figures.h"
#include "tb/designs/dda/sweeps.h"
#include "tests/designs/dda/records.h"
#include "tests/support/judged.h"

namespace cosim::dda {
namespace {

std::vector<Job> jobs(int width, std::uint64_t count) {
  return test::drawn_jobs(random_job, width, count);
}

TEST(DdaChecker, PassesWhatTheOracleDraws) {
  for (const int width : {3, 6, 10, 32}) {
    const auto all = jobs(width, 400);
    std::uint64_t steps = 0;
    double deviated = 0;
    for (const Job& job : all) {
      Track track(width, job);
      while (const auto step = track.next()) {
        if (*step == Point{}) continue;
        ++steps;
        deviated = std::max(deviated, deviation(job, track.at()));
      }
    }
    test::expect_passes<Design, CurveFigures>(of_width(width), all, steps, deviated);
  }
}

TEST(DdaChecker, SeesEveryWrongStepCodeAndEnd) {
  test::expect_faults_seen<Design, CurveFigures>(
      of_width(6), jobs(6, 100), [](Outputs<Word>& outputs, std::uint64_t how) {
        auto out = named<Shown>(outputs);
        Word* pins[] = {&out.x_up,   &out.x_down, &out.y_up, &out.y_down,
                        &out.code_x, &out.code_y, &out.busy};
        if (out.busy == 0) return false;
        *pins[how % std::size(pins)] ^= 1;
        outputs = record_of<Outputs<Word>>(out);
        return true;
      });
}

}  // namespace
}  // namespace cosim::dda
