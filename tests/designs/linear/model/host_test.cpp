// The device outside of SU 1631518, at work on the model.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "model/linear/oracle.h"
#include "tests/designs/linear/printed.h"
#include "tests/support/model_adapter.h"
#include "tests/support/model_machine.h"

namespace cosim::linear {
namespace {

using printed::Clocks;

Clocks draw(const std::vector<Job>& jobs) {
  return printed::draw(test::model_bench<Design, of(5, 2)>(), jobs);
}

std::vector<Pins> inputs(const std::vector<Job>& jobs) {
  HostOf<Design> host(of(5, 2), jobs);
  std::vector<Pins> all;
  test::ModelMachine<Design> machine(of(5, 2));
  auto seen = record_of<Outputs<Word>>(Shown{1, 1, 0, 0});  // of no meaning on the first call
  for (Inputs<Word> in; host.next(in, seen);) {
    all.push_back(named<Pins>(in));
    seen = machine.clock(in);
  }
  return all;
}

TEST(LinearHost, HasNothingToDoWithoutLines) { EXPECT_TRUE(inputs({}).empty()); }

TEST(LinearHost, WritesBpThenUkThenStarts) {
  const auto in = inputs({{{27, 0b01010}, {}}});
  ASSERT_EQ(in.size(), 9U);  // three, one, four words, one
  const auto expect = [&](std::size_t clock, Word bp, Word uk, Word start, Word data) {
    EXPECT_EQ(in[clock].write_bp, bp);
    EXPECT_EQ(in[clock].write_uk, uk);
    EXPECT_EQ(in[clock].start, start);
    EXPECT_EQ(in[clock].data, data);
  };
  expect(0, 1, 0, 0, 27);
  expect(1, 0, 1, 0, 0b01010);
  expect(2, 0, 0, 1, 0);
  for (std::size_t clock = 3; clock < in.size(); ++clock) expect(clock, 0, 0, 0, 0);
  for (const auto& i : in) {
    EXPECT_EQ(i.initial_set_n, 1);
    EXPECT_EQ(i.reset, 0);
  }
}

TEST(LinearHost, DrawsOneLineAfterTheOther) {
  std::vector<Job> jobs;
  for (std::int64_t major : {27, 0, 8, 31, 0, 0, 1}) jobs.push_back({{major, 0b01010}, {}});
  const Clocks clocks = draw(jobs);
  std::size_t at = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const auto words = static_cast<std::size_t>(ticks(3, jobs[i].line.major));
    EXPECT_EQ(printed::strobed(clocks, i).size(), words) << "line " << i;
    for (std::size_t c = 0; c < 5 + words; ++c, ++at) {
      ASSERT_LT(at, clocks.size());
      EXPECT_EQ(clocks[at].job, i);
    }
    EXPECT_EQ(clocks[at - 1].outputs.busy, 0);
  }
  EXPECT_EQ(at, clocks.size());
}

// Input 17 falls on the clock after the last word asked for; the word that stands formed by then
// still comes out. The line is forgotten: the next one is whole.
TEST(LinearHost, GivesALineUp) {
  for (std::int64_t words = 0; words <= 6; ++words) {
    SCOPED_TRACE(words);
    const std::vector<Job> jobs = {{{27, 0b01010}, words}, {{27, 0b01010}, {}}};
    const Clocks clocks = draw(jobs);
    EXPECT_EQ(printed::strobed(clocks, 0).size(), std::min<std::int64_t>(words + 1, 4));
    const Clocks whole = printed::strobed(clocks, 1);
    ASSERT_EQ(whole.size(), 4U);
    for (std::size_t w = 0; w < 4; ++w) {
      EXPECT_EQ(whole[w].outputs.minor, printed::kTable3Minor[w]);
    }
  }
}

// The words of a line are counted from its own start.
TEST(LinearHost, GivesEachLineUpByItself) {
  const std::vector<Job> jobs(3, {{27, 0b01010}, 1});
  const Clocks clocks = draw(jobs);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    EXPECT_EQ(printed::strobed(clocks, i).size(), 2U) << "line " << i;
  }
}

TEST(LinearHost, GivesNoEmptyLineUp) {
  const std::vector<Job> jobs = {{{0, 0b01010}, 0}, {{8, 0b01010}, {}}};
  const Clocks clocks = draw(jobs);
  EXPECT_TRUE(printed::strobed(clocks, 0).empty());
  EXPECT_EQ(printed::strobed(clocks, 1).size(), 1U);
}

// Each is smaller in one respect and larger in none, so that shrinking ends.
TEST(LinearHost, TriesSmallerJobs) {
  constexpr Params p = of(5, 2);
  const auto size = [](const Job& job) {
    const auto words = job.words ? *job.words + 1 : 0;
    return std::array{job.line.major, static_cast<std::int64_t>(job.line.code), words};
  };
  for (std::int64_t major = 0; major < 32; ++major) {
    for (const std::optional<std::int64_t> words : {std::optional<std::int64_t>{}, {0}, {1}, {5}}) {
      const Job job{{major, 0b01010}, words};
      for (const Job& smaller : smaller(p, job)) {
        EXPECT_NE(size(smaller), size(job)) << describe(p, job);
        for (std::size_t i = 0; i < size(job).size(); ++i) {
          EXPECT_LE(size(smaller)[i], size(job)[i]) << describe(p, job);
        }
      }
    }
  }
}

}  // namespace
}  // namespace cosim::linear
