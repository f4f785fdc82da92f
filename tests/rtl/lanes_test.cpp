// Planted faults in lanes: each is found by the case, on the clock and at the signal that lockstep
// names, and whatever lockstep does not see is said to be an error.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "tests/rtl/variant_lanes.h"
#include "tests/support/designs.h"

namespace cosim::test {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::uint64_t kClocks = 100'000;

// Two of each design, one of them in what a reset leaves, and with $COSIM_LANES_ALL every fault.
bool wanted(const std::string& variant) {
  static const std::set<std::string> handful = {
      "faults/priority_missing", "faults/remainder_not_cleared", "faults/two_from_one",
      "faults/sector_not_cleared", "faults/borrow_missed"};
  return variant.starts_with("faults/") &&
         (handful.contains(variant) || std::getenv("COSIM_LANES_ALL") != nullptr);
}

template <class Design>
class InLanes : public testing::Test {};
TYPED_TEST_SUITE(InLanes, Designs, DesignNames);

TYPED_TEST(InLanes, FaultsAreFoundWhereLockstepFindsThem) {
  int faults = 0;
  for (const auto& v : variants<TypeParam>()) {
    if (!wanted(v.name)) continue;
    SCOPED_TRACE(v.name + ": " + v.what);
    ++faults;
    const auto built = in_lanes(v, 64);
    const Result alone = run_sweep(hostile_sweep(*v.bench, kSeed, kClocks), 1);
    ASSERT_TRUE(alone.mismatch);
    for (const unsigned threads : {1U, 2U}) {
      expect_equal(run_sweep(lanes::hostile_sweep(*v.bench, *built, kSeed, kClocks), threads),
                   alone);
    }
  }
  EXPECT_GE(faults, 1);
}

// The lanes of one RTL and the bench of another.
TYPED_TEST(InLanes, WhatLockstepDoesNotSeeIsAnError) {
  for (const auto& v : variants<TypeParam>()) {
    if (!wanted(v.name) || v.name.ends_with("_not_cleared")) continue;
    for (const auto& good : variants<TypeParam>()) {
      if (!good.name.starts_with("shipped/") || good.bench->title() != v.bench->title()) continue;
      const auto built = in_lanes(v, 64);
      const Sweep sweep = lanes::hostile_sweep(*good.bench, *built, kSeed, kClocks);
      EXPECT_THROW(run_sweep(sweep, 1), lanes::Unconfirmed);
      return;
    }
  }
  FAIL() << "no fault to try it with";
}

}  // namespace
}  // namespace cosim::test
