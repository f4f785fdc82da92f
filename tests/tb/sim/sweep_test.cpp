// Sweeps made up for the purpose: which case is reported, the sums, what is thrown.
// Needs: circular
#include "tb/sim/sweep.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "tests/designs/circular/records.h"
#include "tests/support/model_adapter.h"

namespace cosim {
namespace {

using namespace std::chrono_literals;

Result passed() {
  Result r;
  r.cases = 1;
  r.clocks = 10;
  r.checked.jobs = 2;
  r.checked.measures = {{"steps", Measure::Sum::total, "", "step", std::uint64_t{3}},
                        {"off", Measure::Sum::largest, "", "step", 0.5}};
  return r;
}

Result failed(std::uint64_t i) {
  Result r = passed();
  r.checked.error = "wrong in " + std::to_string(i);
  r.failed = "made up";
  return r;
}

class SweepOf : public testing::TestWithParam<unsigned> {};

TEST_P(SweepOf, SumsItsCases) {
  const auto run = [](std::uint64_t i) {
    Result r = passed();
    r.clocks = i;
    if (i == 600) r.checked.measures.back().value = 0.75;
    return r;
  };
  const Result sum = run_sweep({"sums", 1000, run}, GetParam());
  EXPECT_TRUE(sum.match());
  EXPECT_EQ(sum.cases, 1000U);
  EXPECT_EQ(sum.clocks, 999U * 1000 / 2);
  EXPECT_EQ(sum.checked.jobs, 2000U);
  EXPECT_EQ(sum.checked.count("steps"), 3000U);
  EXPECT_EQ(sum.checked.number("off"), 0.75);
  EXPECT_EQ(sum.failed, "");
}

TEST_P(SweepOf, RunsEachCaseOnce) {
  std::array<std::atomic<int>, 500> runs{};
  run_sweep({"once", 500, [&](std::uint64_t i) { return ++runs[i], passed(); }}, GetParam());
  for (const auto& n : runs) EXPECT_EQ(n, 1);
}

TEST_P(SweepOf, NoCasesIsAMatchOfNone) {
  const Result none = run_sweep({"none", 0, failed}, GetParam());
  EXPECT_TRUE(none.match());
  EXPECT_EQ(none.cases, 0U);
}

// Whether it is in before the other failing cases or behind them.
TEST_P(SweepOf, ReportsTheLowestFailingCase) {
  for (const std::uint64_t slow : {20U, 21U}) {
    const auto run = [slow](std::uint64_t i) {
      if (i == slow) std::this_thread::sleep_for(20ms);
      return i == 20 || i == 21 || i == 23 || i == 40 ? failed(i) : passed();
    };
    for (int round = 0; round < 10; ++round) {
      const Result result = run_sweep({"lowest", 1000, run}, GetParam());
      EXPECT_FALSE(result.match());
      EXPECT_EQ(result.checked.error, "wrong in 20");
      EXPECT_EQ(result.failed, "case 20: made up");
    }
  }
}

TEST_P(SweepOf, BeginsNoCaseBehindAFailedOne) {
  std::mutex guard;
  std::set<std::uint64_t> begun;
  const auto run = [&](std::uint64_t i) {
    const std::lock_guard lock(guard);
    begun.insert(i);
    return i >= 5 ? failed(i) : passed();
  };
  const Result result = run_sweep({"stops", 1'000'000, run}, GetParam());
  EXPECT_EQ(result.failed, "case 5: made up");
  // One a thread may have been on its way.
  EXPECT_LE(begun.size(), 6U + std::max(GetParam(), 1U));
  EXPECT_EQ(result.cases, 6U);
}

TEST_P(SweepOf, ReportsALockstepDifferenceWithItsTraces) {
  const auto run = [](std::uint64_t i) {
    Result r = passed();
    if (i % 7 != 3) return r;
    r.failed = "made up";
    r.mismatch = Mismatch{};
    r.mismatch->clock = 100 + i;
    return r;
  };
  const Result result = run_sweep({"lockstep", 50, run}, GetParam());
  ASSERT_TRUE(result.mismatch);
  EXPECT_EQ(result.mismatch->clock, 103U);
  EXPECT_EQ(result.checked.error, "");
  EXPECT_EQ(result.failed, "case 3: made up");
}

TEST_P(SweepOf, PassesAnExceptionThrough) {
  std::atomic<int> begun = 0;
  const auto run = [&](std::uint64_t i) -> Result {
    ++begun;
    if (i == 5) throw std::domain_error("five");
    return passed();
  };
  try {
    run_sweep({"throws", 1'000'000'000, run}, GetParam());
    FAIL() << "nothing was thrown";
  } catch (const std::domain_error& e) {
    EXPECT_STREQ(e.what(), "five");
  }
  EXPECT_LT(begun, 100'000'000);  // the others stopped, too
}

// From every sum that it keeps, a sweep comes to the same end; one that fails, too.
TEST_P(SweepOf, GoesOnFromWhatItKept) {
  const auto run = [](std::uint64_t i) {
    std::this_thread::sleep_for(1ms);
    Result r = i == 700 ? failed(i) : passed();
    r.clocks = i;
    return r;
  };
  std::vector<Result> kept;
  Resume resume;
  resume.keep = [&](const Result& done) { kept.push_back(done); };
  const Result whole = run_sweep({"kept", 1000, run}, GetParam(), {}, resume);
  EXPECT_EQ(whole.clocks, 700U * 701 / 2);
  ASSERT_FALSE(kept.empty());
  for (const Result& done : kept) {
    EXPECT_EQ(done.clocks, done.cases == 0 ? 0 : done.cases * (done.cases - 1) / 2);
    const Result rest = run_sweep({"rest", 1000, run}, GetParam(), {}, {done, {}});
    EXPECT_EQ(rest.cases, 701U);
    EXPECT_EQ(rest.clocks, whole.clocks);
    EXPECT_EQ(rest.checked.count("steps"), whole.checked.count("steps"));
    EXPECT_EQ(rest.failed, whole.failed);
  }
}

TEST_P(SweepOf, TellsOfItsProgress) {
  const auto caller = std::this_thread::get_id();
  std::uint64_t last = 0;
  int calls = 0;
  const auto run = [](std::uint64_t) {
    std::this_thread::sleep_for(30ms);
    return passed();
  };
  run_sweep({"slow", 16, run}, GetParam(), [&](std::uint64_t done, std::uint64_t cases) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_EQ(cases, 16U);
    EXPECT_GE(done, last);
    last = done;
    ++calls;
  });
  EXPECT_EQ(last, 16U);
  EXPECT_GE(calls, 1);
}

// However long that one takes: here until the others rest.
TEST_P(SweepOf, RunsNotFarAheadOfASlowCase) {
  const std::uint64_t far = most_waiting + GetParam();
  std::atomic<std::uint64_t> begun{0};
  std::uint64_t ahead = 0;
  const auto run = [&](std::uint64_t i) {
    ++begun;
    if (i != 0) return passed();
    for (std::uint64_t before = 0; before != begun && begun <= far;) {
      before = begun;
      std::this_thread::sleep_for(100ms);
    }
    ahead = begun;
    return passed();
  };
  EXPECT_EQ(run_sweep({"slow", 2 * far, run}, GetParam()).cases, 2 * far);
  EXPECT_LE(ahead, far);
}

INSTANTIATE_TEST_SUITE_P(Threads, SweepOf, testing::Values(1U, 2U, 5U),
                         testing::PrintToStringParamName());

TEST(Sweep, NoThreadsCountsAsOne) {
  EXPECT_EQ(run_sweep({"", 10, [](std::uint64_t) { return passed(); }}, 0).cases, 10U);
}

TEST(HostileSweep, HasAsManyClocksAsAsked) {
  const AnyBench& bench = test::model_bench<circular::Design, circular::of_width(8)>();
  for (const std::uint64_t clocks : {0U, 1U, 999U, 1000U, 1001U, 2500U}) {
    const Result result = run_sweep(hostile_sweep(bench, 3, clocks), 2);
    EXPECT_TRUE(result.match());
    EXPECT_EQ(result.clocks, clocks);
    EXPECT_EQ(result.cases, (clocks + 999) / 1000);
  }
}

}  // namespace
}  // namespace cosim
