// An order of statements is run by what it says alone: registers, places and the values in them.
#include "tb/lanes/schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>

#include "tb/util/random.h"

namespace cosim::lanes {
namespace {

constexpr std::size_t none = Statement::none;

/// Statements at random: values 0 .. 19 are in memory from the beginning on.
struct Some {
  std::vector<Statement> statements;
  std::size_t values = 20;

  explicit Some(std::uint64_t seed) {
    Random random(seed);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random.below(n)); };
    const auto reads = [&](std::size_t most) {
      std::vector<std::size_t> all;
      for (std::size_t i = 0; i < most; ++i) {
        const std::size_t v = below(values);
        if (std::find(all.begin(), all.end(), v) == all.end()) all.push_back(v);
      }
      return all;
    };
    for (int i = 0; i < 100; ++i) {
      statements.push_back({reads(3), values});
      ++values;
    }
    // Each value has an end, of which some wait for all that read one from the beginning.
    for (std::size_t v = 20; v < values; ++v) statements.push_back({{v}});
    for (std::size_t v = 0; v < 20; ++v) {
      const std::size_t end = 100 + below(100);
      for (std::size_t s = 0; s < 100; ++s) {
        const auto& of = statements[s].reads;
        if (std::find(of.begin(), of.end(), v) != of.end()) statements[end].after.push_back(s);
      }
    }
  }
};

TEST(Schedule, RunsEachStatementOnceOnWhatItReads) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Some some(seed);
    for (const std::size_t registers : {4U, 7U, 30U}) {
      const Schedule schedule = scheduled(some.statements, some.values, registers);
      std::set<std::size_t> held, leaving, done;
      std::vector<std::optional<std::size_t>> places(schedule.places);
      std::vector<std::size_t> left(some.values);
      for (const Statement& s : some.statements) {
        for (const std::size_t v : s.reads) ++left[v];
      }
      for (const Move& move : schedule.moves) {
        if (move.what == Move::What::load) {
          const auto from = move.place == none ? std::nullopt : places[move.place];
          ASSERT_TRUE(from == move.of || (!from && move.of < 20)) << move.of;
          held.insert(move.of);
        } else if (move.what == Move::What::leave) {
          ASSERT_EQ(held.count(move.of), 1U);
          leaving.insert(move.of);
          if (move.place != none) places[move.place] = move.of;
        } else {
          const Statement& s = some.statements[move.of];
          for (const std::size_t v : s.reads) {
            ASSERT_EQ(held.count(v), 1U) << v;
            if (--left[v] == 0) held.erase(v);
          }
          for (const std::size_t before : s.after) ASSERT_EQ(done.count(before), 1U);
          ASSERT_TRUE(done.insert(move.of).second);
          for (const std::size_t v : leaving) held.erase(v);
          leaving.clear();
          if (s.gives != none) held.insert(s.gives);
        }
        ASSERT_LE(held.size() - leaving.size(), registers);
      }
      EXPECT_EQ(done.size(), some.statements.size());
    }
  }
}

}  // namespace
}  // namespace cosim::lanes
