// What a check found: its measures, by name, in words and added up.
#include "tb/sim/checked.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tb/sim/result.h"

namespace cosim {
namespace {

Measure turns(std::uint64_t n) { return {"turns", Measure::Sum::total, "", "turn", n}; }
Measure off(double n) { return {"off", Measure::Sum::largest, "largest deviation", "step", n}; }
Measure deepest(std::uint64_t n) {
  return {"deepest", Measure::Sum::largest, "deepest", "entry", n};
}
Measure time(double n) { return {"time", Measure::Sum::total, "", "clock", n}; }

Checked found(std::vector<Measure> measures) { return {1, "", std::move(measures)}; }

TEST(Measures, AreShownWithTheirUnits) {
  EXPECT_EQ(to_text(turns(1)), "1 turn");
  EXPECT_EQ(to_text(turns(27)), "27 turns");
  EXPECT_EQ(to_text(off(0.36895)), "largest deviation 0.369 steps");
  EXPECT_EQ(to_text(off(1)), "largest deviation 1 step");
  EXPECT_EQ(to_text(off(0.49961)), "largest deviation 0.4996 steps");
}

TEST(Measures, AreAddedUpAsTheySay) {
  Checked sum = found({turns(3), off(0.5), deepest(7), time(1.5)});
  add(sum, found({off(0.25), turns(4), deepest(9), time(0.25)}));
  EXPECT_EQ(sum.jobs, 2U);
  ASSERT_EQ(sum.measures.size(), 4U);
  EXPECT_EQ(sum.count("turns"), 7U);
  EXPECT_EQ(sum.number("off"), 0.5);
  EXPECT_EQ(sum.count("deepest"), 9U);
  EXPECT_EQ(sum.number("time"), 1.75);
}

TEST(Measures, AreThoseOfAll) {
  Checked sum;
  add(sum, found({turns(3)}));
  add(sum, found({}));
  add(sum, found({off(2)}));
  EXPECT_EQ(sum.count("turns"), 3U);
  EXPECT_EQ(sum.number("off"), 2);
  EXPECT_THROW(sum.measure("steps"), std::out_of_range);
}

TEST(Measures, OfOneNameAreTakenInOneWay) {
  Checked sum = found({turns(3)});
  Measure other = turns(4);
  other.sum = Measure::Sum::largest;
  EXPECT_THROW(add(sum, found({other})), InputError);
  other = turns(4);
  other.value = 4.0;
  EXPECT_THROW(add(sum, found({other})), InputError);
}

Result failing(const std::string& name, const std::string& error) {
  Result r;
  r.cases = 1;
  r.clocks = 10;
  r.checked.error = error;
  if (error.empty()) r.mismatch.emplace();
  r.failed = name;
  return r;
}

TEST(Results, KeepTheFirstFailure) {
  Result sum;
  add(sum, {.cases = 2, .clocks = 5, .checked = found({turns(3)}), .mismatch = {}, .failed = ""});
  EXPECT_TRUE(sum.match());
  add(sum, failing("first", ""));
  add(sum, failing("second", "oracle 8, machine 7"));
  EXPECT_TRUE(sum.mismatch);
  EXPECT_EQ(sum.failed, "first");
  EXPECT_EQ(sum.checked.error, "");
  EXPECT_EQ(sum.cases, 4U);
  EXPECT_EQ(sum.clocks, 25U);
  EXPECT_EQ(sum.checked.count("turns"), 3U);
  add(sum = {}, failing("third", "oracle 8, machine 7"));
  EXPECT_EQ(sum.checked.error, "oracle 8, machine 7");
  EXPECT_EQ(sum.failed, "third");
}

}  // namespace
}  // namespace cosim
