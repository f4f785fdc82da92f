// The erratum of the DDA's source that changes what is drawn: nothing stops an axis that is done
// (D4). On RTL without the stop an axis overruns; lockstep finds it; the RTL as shipped does not.
#include <gtest/gtest.h>

#include "model/dda/host.h"
#include "tests/rtl/straight.h"

namespace cosim::dda {
namespace {

using Script = test::Script<Design>;
using Variant = test::Variant<Design>;

const Variant& printed() { return test::variant<Design>("errata/d4"); }
const Variant& shipped() { return test::variant<Design>("shipped/w6"); }

// From 0 both accumulators of a quarter are late, and at its end that of X is later: Y has to wait.
Script quarter(std::int64_t radius) {
  const Params p{6};
  const std::vector<Job> jobs{arc(p, {radius, 0}, {0, radius}, {})};
  Host host(p, jobs);
  Script script;
  Inputs<Word> in;
  Outputs<Word> seen{};
  State<Word> state;
  while (host.next(in, seen)) {
    script.push_back(in);
    const auto step = next(p, state, in);
    seen = step.outputs;
    state = step.state;
  }
  return script;
}

std::int64_t highest(const Variant& variant, const Script& script) {
  std::int64_t most = 0;
  for (const auto& clock : test::play(variant, script)) most = std::max(most, clock.outputs.code_y);
  return most;
}

TEST(DdaErratumD4, AnAxisThatIsDoneOverrunsAsPrinted) {
  int overrun = 0;
  for (std::int64_t radius = 1; radius < 60; ++radius) {
    overrun += highest(printed(), quarter(radius)) > radius;
    EXPECT_EQ(highest(shipped(), quarter(radius)), radius);
  }
  EXPECT_GT(overrun, 10);
}

TEST(DdaErratumD4, IsFound) {
  const Script script = quarter(12);
  EXPECT_NE(test::reported(printed().run_inputs(script, 1)), std::nullopt);
  test::expect_same(shipped(), script);
}

}  // namespace
}  // namespace cosim::dda
