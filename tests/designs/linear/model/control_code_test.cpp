#include "model/linear/control_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "model/core/input_error.h"

namespace cosim::linear {
namespace {

// The bit that decides position q, found by halving: q = 2^(i-1) * odd.
int bit_of(std::int64_t q) { return q % 2 != 0 ? 1 : 1 + bit_of(q / 2); }

bool steps_at(int m, Code code, std::int64_t q) {
  const int i = bit_of(q);
  return i <= m && (code >> (m - i)) % 2 == 1;
}

std::int64_t walked_steps(int m, std::int64_t major, Code code) {
  std::int64_t count = 0;
  for (std::int64_t q = 1; q <= major; ++q) count += steps_at(m, code, q);
  return count;
}

// The largest |BP * count(q) - q * MP| of a walk over all positions.
std::int64_t walked_deviation(int m, std::int64_t major, Code code) {
  const std::int64_t minor = walked_steps(m, major, code);
  std::int64_t count = 0, worst = 0;
  for (std::int64_t q = 1; q <= major; ++q) {
    count += steps_at(m, code, q);
    worst = std::max(worst, std::abs(major * count - q * minor));
  }
  return worst;
}

std::uint64_t scaled(const Deviation& d) { return d.whole * d.denominator + d.numerator; }

void expect_walked_deviation(int m, std::int64_t major, Code code) {
  const Deviation d = max_deviation(m, major, code);
  ASSERT_EQ(d.denominator, static_cast<std::uint64_t>(major));
  ASSERT_LT(d.numerator, d.denominator);
  ASSERT_EQ(scaled(d), static_cast<std::uint64_t>(walked_deviation(m, major, code)))
      << "m " << m << " BP " << major << " UK " << code;
}

double to_two_decimals(double v) { return std::round(v * 100) / 100; }

TEST(ControlCodeWeight, OfTheSourcesExample) {
  const std::vector<std::int64_t> expected = {14, 7, 3, 2, 1};
  for (int i = 1; i <= 5; ++i) EXPECT_EQ(weight(i, 27), expected[static_cast<std::size_t>(i - 1)]);
}

TEST(ControlCodeWeight, CountsThePositionsOfItsBit) {
  for (std::int64_t major = 0; major < 256; ++major) {
    std::int64_t sum = 0;
    for (int i = 1; i <= 8; ++i) {
      ASSERT_EQ(weight(i, major), walked_steps(8, major, Code{1} << (8 - i)));
      sum += weight(i, major);
    }
    ASSERT_EQ(sum, major);
  }
}

TEST(ControlCodeMinorSteps, AreThoseOfAWalkForEveryCode) {
  for (std::int64_t major = 0; major < 64; ++major) {
    for (Code code = 0; code < 64; ++code) {
      ASSERT_EQ(minor_steps(6, major, code), walked_steps(6, major, code));
    }
  }
}

TEST(ControlCode, GiveEveryLineOfEightBitsItsMinorSteps) {
  for (std::int64_t major = 0; major < 256; ++major) {
    for (std::int64_t minor = 0; minor <= major; ++minor) {
      ASSERT_EQ(walked_steps(8, major, greedy_code(8, major, minor)), minor) << "BP " << major;
      ASSERT_EQ(walked_steps(8, major, best_code(8, major, minor)), minor) << "BP " << major;
    }
  }
}

TEST(ControlCode, GreedyFindsTheSourcesExample) { EXPECT_EQ(greedy_code(5, 27, 9), 0b01010U); }

// Of the 392 lines with BP >= 16 in 5 bits, 120 have more than one code; none, in any width, has
// more than two.
TEST(ControlCode, AreOneOrTwoForALine) {
  std::map<int, int> lines_of_five_bits;
  for (int m = 1; m <= 9; ++m) {
    for (std::int64_t major = std::int64_t{1} << (m - 1); major >> m == 0; ++major) {
      std::vector<int> codes(static_cast<std::size_t>(major) + 1);
      for (Code code = 0; code >> m == 0; ++code) {
        ++codes[static_cast<std::size_t>(minor_steps(m, major, code))];
      }
      for (int n : codes) {
        ASSERT_TRUE(n == 1 || n == 2) << "BP " << major << " has " << n << " codes";
        if (m == 5) ++lines_of_five_bits[n];
      }
    }
  }
  EXPECT_EQ(lines_of_five_bits, (std::map<int, int>{{1, 272}, {2, 120}}));
}

TEST(ControlCodeBestCode, IsTheLeastDeviationThenTheLeastNumberOfAllCodes) {
  constexpr int m = 7;
  for (std::int64_t major = 1; major < 128; ++major) {
    Code weightless = 0;
    for (int i = 1; i <= m; ++i) weightless |= Code{weight(i, major) == 0} << (m - i);
    struct Best {
      std::int64_t deviation;
      Code code;
    };
    std::map<std::int64_t, Best> best;
    for (Code code = 0; code < 128; ++code) {
      if ((code & weightless) != 0) continue;
      const Best here{walked_deviation(m, major, code), code};
      const auto [it, first] = best.try_emplace(walked_steps(m, major, code), here);
      if (!first && here.deviation < it->second.deviation) it->second = here;
    }
    for (std::int64_t minor = 0; minor <= major; ++minor) {
      ASSERT_EQ(best_code(m, major, minor), best.at(minor).code) << major << " by " << minor;
    }
  }
}

TEST(ControlCodeMaxDeviation, IsThatOfAWalkForEveryLineAndCode) {
  for (int m = 1; m <= 7; ++m) {
    for (std::int64_t major = 1; major >> m == 0; ++major) {
      for (Code code = 0; code >> m == 0; ++code) {
        ASSERT_NO_FATAL_FAILURE(expect_walked_deviation(m, major, code));
      }
    }
  }
}

TEST(ControlCodeMaxDeviation, IsThatOfAWalkForLongLines) {
  std::mt19937_64 random(1631518);
  constexpr Code kBits = (Code{1} << 18) - 1;
  for (int n = 0; n < 20; ++n) {
    const auto major = static_cast<std::int64_t>((random() & kBits) | 1);
    ASSERT_NO_FATAL_FAILURE(expect_walked_deviation(18, major, random() & kBits));
  }
}

// The full line of 32 bits with one step in the middle, at q = 2^31: it is late by 2^31 - 1 parts
// of BP just before and early by as many just after. The code with a step on every other position
// is early by as many at q = 1 and late at q = BP - 1.
TEST(ControlCodeMaxDeviation, HoldsForTheLongestLine) {
  constexpr std::int64_t kMajor = 0xffff'ffff;
  const Deviation expected{0, 0x7fff'ffff, 0xffff'ffff};
  EXPECT_EQ(max_deviation(32, kMajor, 1), expected);
  EXPECT_EQ(max_deviation(32, kMajor, 0x8000'0000), expected);
  EXPECT_EQ(max_deviation(32, kMajor, 0xffff'ffff), (Deviation{0, 0, 0xffff'ffff}));
  EXPECT_EQ(best_code(32, kMajor, 1), 1U);
}

struct Worst {
  int m;
  double greedy, best;
};

class ControlCodeWorst : public testing::TestWithParam<Worst> {};

TEST_P(ControlCodeWorst, DeviationIsLandedOn) {
  const auto [m, expected_greedy, expected_best] = GetParam();
  double greedy = 0, best = 0;
  for (std::int64_t major = std::int64_t{1} << (m - 1); major >> m == 0; ++major) {
    for (std::int64_t minor = 0; minor <= major; ++minor) {
      greedy = std::max(greedy, max_deviation(m, major, greedy_code(m, major, minor)).value());
      best = std::max(best, max_deviation(m, major, best_code(m, major, minor)).value());
    }
  }
  EXPECT_DOUBLE_EQ(to_two_decimals(greedy), expected_greedy);
  EXPECT_DOUBLE_EQ(to_two_decimals(best), expected_best);
}

INSTANTIATE_TEST_SUITE_P(Width, ControlCodeWorst,
                         testing::Values(Worst{4, 1.00, 0.92}, Worst{5, 1.33, 1.27},
                                         Worst{6, 1.57, 1.53}, Worst{7, 1.91, 1.87},
                                         Worst{8, 2.15, 2.14}),
                         [](const auto& width) { return "m" + std::to_string(width.param.m); });

TEST(ControlCodeEmptyLine, HasCodeZeroAndNoDeviation) {
  EXPECT_EQ(greedy_code(5, 0, 0), 0U);
  EXPECT_EQ(best_code(5, 0, 0), 0U);
  EXPECT_EQ(max_deviation(5, 0, 31), Deviation{});
  EXPECT_EQ(Deviation{}.value(), 0);
}

std::string complaint(int m, std::int64_t major, std::int64_t minor) {
  try {
    greedy_code(m, major, minor);
  } catch (const InputError& e) {
    EXPECT_THROW(best_code(m, major, minor), InputError);
    return e.what();
  }
  return "no complaint";
}

TEST(ControlCodeBadLine, IsNamedInOneLine) {
  const std::string too_long = " steps does not fit: a machine of 5 bits draws 0 to 31";
  const std::string steps =
      "a line with 9 steps on its major axis has 0 to 9 on the minor axis, not ";
  EXPECT_EQ(complaint(5, 32, 1), "a line of 32" + too_long);
  EXPECT_EQ(complaint(5, -1, 0), "a line of -1" + too_long);
  EXPECT_EQ(complaint(5, 9, 10), steps + "10");
  EXPECT_EQ(complaint(5, 9, -1), steps + "-1");
  EXPECT_EQ(complaint(0, 0, 0), "a control code has 1 to 32 bits, not 0");
  EXPECT_EQ(complaint(33, 1, 1), "a control code has 1 to 32 bits, not 33");
}

TEST(ControlCodeArithmetic, IsTotal) {
  using Limits = std::numeric_limits<std::int64_t>;
  EXPECT_EQ(weight(0, 5), 0);
  EXPECT_EQ(weight(64, Limits::max()), 0);
  EXPECT_EQ(weight(63, Limits::max()), 1);
  EXPECT_EQ(weight(1, Limits::min()), 0);
  EXPECT_EQ(minor_steps(std::numeric_limits<int>::max(), Limits::max(), ~Code{0}), 0);
  EXPECT_EQ(minor_steps(63, Limits::max(), ~Code{0}), Limits::max());
  EXPECT_EQ(minor_steps(-1, 5, 1), 0);
  EXPECT_EQ(minor_steps(64, 5, Code{1} << 63), 3);
  EXPECT_EQ(scaled(max_deviation(63, Limits::max(), 1)), (std::uint64_t{1} << 62) - 1);
  EXPECT_EQ(scaled(max_deviation(63, Limits::max(), ~Code{0})), 0U);
  EXPECT_EQ(max_deviation(63, Limits::min(), 1), Deviation{});
}

}  // namespace
}  // namespace cosim::linear
