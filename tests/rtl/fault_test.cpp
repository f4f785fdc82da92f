// Faults planted in the RTL, each of which hostile clocks must find; and where they find it must be
// where the fault first shows.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "tests/rtl/straight.h"
#include "tests/support/designs.h"
#include "tests/support/explain.h"

namespace cosim::test {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::uint64_t kClocks = 1000;
constexpr std::uint64_t kCases = 100;  // so within 100 000 clocks

/// A case's inputs.
template <class Design>
Script<Design> hostile_script(const typename Design::Params& p, const HostileCase& c) {
  return script_of<Design>(HostileStimulus<Design>(p, c));
}

template <class Design>
void expect_fault_found(const Variant<Design>& variant) {
  std::uint64_t clocks = 0;
  for (std::uint64_t i = 0; i < kCases; ++i) {
    const HostileCase c{kSeed, i, kClocks};
    const Run run = variant.bench->run_hostile(c);
    clocks += run.clocks;
    const auto script = hostile_script<Design>(variant.bench->params(), c);
    const auto first = straight_run(variant, script, c.power_up());
    ASSERT_EQ(reported(run), first) << variant.what << "\ncase " << i;
    ASSERT_EQ(run.clocks, first ? first->clock + 1 : kClocks) << variant.what << "\ncase " << i;
    if (first) {
      testing::Test::RecordProperty("clocks", std::to_string(clocks));
      testing::Test::RecordProperty("signal", first->signal);
      return;
    }
  }
  ADD_FAILURE() << variant.what << "\nnot found in " << clocks << " clocks";
}

template <class Design>
void expect_nothing_found(const Variant<Design>& variant) {
  for (std::uint64_t i = 0; i < kCases; ++i) {
    const HostileCase c{kSeed, i, kClocks};
    const Run run = variant.bench->run_hostile(c);
    ASSERT_FALSE(run.mismatch) << explain(*run.mismatch) << "case " << i;
    ASSERT_EQ(run.clocks, kClocks);
    const auto script = hostile_script<Design>(variant.bench->params(), c);
    ASSERT_EQ(straight_run(variant, script, c.power_up()), std::nullopt) << "case " << i;
  }
}

template <class Design>
void add_subjects(std::vector<Subject>& all, const std::string& kind,
                  void (*check)(const Variant<Design>&)) {
  for (const auto& v : variants<Design>()) {
    if (!v.name.starts_with(kind + "/")) continue;
    std::string name = Design::name;
    for (const Parameter& p : v.bench->parameters()) name += p.name + std::to_string(p.value);
    if (kind != "shipped") name += "_" + v.name.substr(kind.size() + 1);
    all.push_back({name, [&v, check] { check(v); }});
  }
}
std::vector<Subject> faults() {
  std::vector<Subject> all;
  for_each_design([&]<class Design>() { add_subjects<Design>(all, "faults", expect_fault_found); });
  return all;
}
std::vector<Subject> controls() {
  std::vector<Subject> all;
  for_each_design(
      [&]<class Design>() { add_subjects<Design>(all, "shipped", expect_nothing_found); });
  return all;
}

class HostileClocksFind : public testing::TestWithParam<Subject> {};
TEST_P(HostileClocksFind, TheFaultWhereItFirstShows) { GetParam().check(); }
INSTANTIATE_TEST_SUITE_P(Faults, HostileClocksFind, testing::ValuesIn(faults()), name_of_subject);

class HostileClocksFindNothing : public testing::TestWithParam<Subject> {};
TEST_P(HostileClocksFindNothing, InTheRtlAsShipped) { GetParam().check(); }
INSTANTIATE_TEST_SUITE_P(Shipped, HostileClocksFindNothing, testing::ValuesIn(controls()),
                         name_of_subject);

// The files are found by a pattern, which may come to match nothing.
template <class Design>
void expect_enough() {
  std::set<std::string> shipped;
  std::map<std::string, int> planted;
  for (const auto& v : variants<Design>()) {
    if (v.name.starts_with("shipped/")) shipped.insert(v.bench->title());
    if (v.name.starts_with("faults/")) ++planted[v.bench->title()];
  }
  int all = 0;
  for (const auto& [title, count] : planted) {
    EXPECT_TRUE(shipped.contains(title)) << "nothing to compare with at " << title;
    all += count;
  }
  EXPECT_GE(all, 12);
}
TEST(Faults, AreManyForEveryDesign) {
  for_each_design([]<class Design>() {
    SCOPED_TRACE(Design::name);
    expect_enough<Design>();
  });
}

}  // namespace
}  // namespace cosim::test
