// Lines: the words of the CSV against the definition of the elementary positions.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>
#include <string>

#include "tests/cli/drawing.h"
#include "tests/cli/help.h"

namespace cosim::cli {
namespace {

struct Shape {
  int m, n;
};
constexpr Shape kShapes[] = {{5, 2}, {6, 3}, {8, 5}, {16, 12}, {16, 13}, {24, 21}, {32, 26}};

std::string bits(std::uint64_t value, int width) {
  std::string text;
  for (int i = width - 1; i >= 0; --i) text += (value >> i & 1) != 0 ? '1' : '0';
  return text;
}

// Position q = 2^(i-1) * odd takes bit a_i, the i-th from the left of UK.
bool minor_steps_at(const std::string& uk, std::uint64_t q) {
  const auto zeros = static_cast<std::size_t>(std::countr_zero(q));
  return zeros < uk.size() && uk[zeros] == '1';
}

struct Expected {
  std::vector<std::string> csv{"tick,major,minor"};
  std::uint64_t minor = 0;
  double max_deviation = 0;
};

Expected definition(std::uint64_t major, const std::string& uk, int n) {
  Expected e;
  for (std::uint64_t q = 1; q <= major; ++q) e.minor += minor_steps_at(uk, q) ? 1 : 0;
  const std::uint64_t word = std::uint64_t{1} << (uk.size() - static_cast<std::size_t>(n));
  std::uint64_t made = 0;
  for (std::uint64_t tick = 0; tick * word < major; ++tick) {
    std::string major_word, minor_word;
    for (std::uint64_t q = tick * word + 1; q <= (tick + 1) * word; ++q) {
      const bool live = q <= major;
      const bool minor = live && minor_steps_at(uk, q);
      major_word += live ? '1' : '0';
      minor_word += minor ? '1' : '0';
      made += minor ? 1 : 0;
      if (!live) continue;
      const double line =
          static_cast<double>(q) * static_cast<double>(e.minor) / static_cast<double>(major);
      e.max_deviation = std::max(e.max_deviation, std::abs(static_cast<double>(made) - line));
    }
    e.csv.push_back(std::to_string(tick + 1) + "," + major_word + "," + minor_word);
  }
  return e;
}

void expect_line(const Drawing& d, std::uint64_t major, const std::string& uk, Shape shape) {
  const Expected e = definition(major, uk, shape.n);
  EXPECT_EQ(d.csv, e.csv);
  EXPECT_EQ(d.report["steps"], major);
  EXPECT_NEAR(d.report["max_deviation"].get<double>(), e.max_deviation, 1e-9);
  EXPECT_EQ(d.report["parameters"], (nlohmann::json{{"M", shape.m}, {"N", shape.n}}));
  EXPECT_EQ(d.ended.out.rfind(
                "linear M=" + std::to_string(shape.m) + " N=" + std::to_string(shape.n) + ": ", 0),
            0U)
      << d.ended.out;
  EXPECT_TRUE(has(d.ended.out, "MP = " + std::to_string(e.minor) + ", UK = " + uk));
}

TEST(Line, OfTheSourceGivesTable3) {
  const Drawing d = draw({"line", "--major", "27", "--minor", "9", "--code", "01010"});
  EXPECT_EQ(d.csv, (std::vector<std::string>{"tick,major,minor", "1,11111111,01000101",
                                             "2,11111111,01000100", "3,11111111,01000101",
                                             "4,11100000,01000000"}));
  expect_line(d, 27, "01010", {5, 2});
}

TEST(Line, WithACodeGivenFollowsItsDefinition) {
  std::mt19937_64 random(1);
  for (const Shape shape : kShapes) {
    for (int i = 0; i < 12; ++i) {
      const std::uint64_t largest = (std::uint64_t{1} << shape.m) - 1;
      const std::uint64_t major = i == 0 ? std::min<std::uint64_t>(largest, 70'000)
                                         : random() % (std::min<std::uint64_t>(largest, 5000) + 1);
      // Of the wide codes only the first bits have a weight on so short a line.
      const std::string uk = bits(random(), shape.m);
      SCOPED_TRACE(std::to_string(major) + " " + uk + " N=" + std::to_string(shape.n));
      Arguments command{"line", "--major", std::to_string(major), "--code", uk};
      command.insert(command.end(),
                     {"--m", std::to_string(shape.m), "--n", std::to_string(shape.n)});
      expect_line(draw(command), major, uk, shape);
      command.insert(command.end(),
                     {"--minor", std::to_string(definition(major, uk, shape.n).minor)});
      if (i == 1) expect_line(draw(command), major, uk, shape);
    }
  }
}

// The code that the text names, which must give the minor steps asked for.
std::string code_of(const Drawing& d, int m) {
  const std::size_t at = d.ended.out.find("UK = ");
  return at == std::string::npos ? "" : d.ended.out.substr(at + 5, static_cast<std::size_t>(m));
}

TEST(Line, WithoutACodeHasTheMinorStepsAskedFor) {
  std::mt19937_64 random(2);
  for (const Shape shape : kShapes) {
    for (int i = 0; i < 6; ++i) {
      const std::uint64_t most = std::min<std::uint64_t>((std::uint64_t{1} << shape.m) - 1, 3000);
      const std::uint64_t major = random() % (most + 1);
      const std::uint64_t minor = i == 0 ? 0 : i == 1 ? major : random() % (major + 1);
      SCOPED_TRACE(std::to_string(major) + " " + std::to_string(minor) +
                   " M=" + std::to_string(shape.m));
      double deviation[2] = {};
      for (const std::string rule : {"best", "greedy"}) {
        const Drawing d =
            draw({"line", "--major", std::to_string(major), "--minor", std::to_string(minor),
                  "--code", rule, "--m", std::to_string(shape.m), "--n", std::to_string(shape.n)});
        const std::string uk = code_of(d, shape.m);
        EXPECT_EQ(definition(major, uk, shape.n).minor, minor);
        expect_line(d, major, uk, shape);
        deviation[rule == "greedy" ? 1 : 0] = d.report["max_deviation"].get<double>();
      }
      EXPECT_LE(deviation[0], deviation[1] + 1e-9);
    }
  }
}

// No code with the same minor steps is better than the best one; best is the default.
TEST(Line, HasTheBestCodeByDefault) {
  for (const auto& [major, minor] :
       {std::pair<std::uint64_t, std::uint64_t>{27, 9}, {31, 13}, {20, 7}, {16, 1}}) {
    const Drawing d =
        draw({"line", "--major", std::to_string(major), "--minor", std::to_string(minor)});
    double least = 1e9;
    for (std::uint64_t code = 0; code < 32; ++code) {
      const Expected e = definition(major, bits(code, 5), 2);
      if (e.minor == minor) least = std::min(least, e.max_deviation);
    }
    EXPECT_NEAR(d.report["max_deviation"].get<double>(), least, 1e-9) << major << " " << minor;
  }
}

TEST(Line, RunsOnTheSmallestMachineThatHoldsIt) {
  const auto machine = [](const Arguments& more, std::uint64_t major) {
    const std::string text =
        cosim(joined({"line", "--major", std::to_string(major), "--minor", "0"}, more)).out;
    return text.substr(0, text.find(':'));
  };
  EXPECT_EQ(machine({}, 0), "linear M=5 N=2");
  EXPECT_EQ(machine({}, 31), "linear M=5 N=2");
  EXPECT_EQ(machine({}, 32), "linear M=6 N=3");
  EXPECT_EQ(machine({}, 63), "linear M=6 N=3");
  EXPECT_EQ(machine({}, 64), "linear M=8 N=5");
  EXPECT_EQ(machine({}, 255), "linear M=8 N=5");
  EXPECT_EQ(machine({}, 256), "linear M=16 N=12");
  EXPECT_EQ(machine({}, 65535), "linear M=16 N=12");
  EXPECT_EQ(machine({}, 65536), "linear M=24 N=21");
  EXPECT_EQ(machine({}, 1 << 24), "linear M=32 N=26");
  EXPECT_EQ(machine({"--n", "13"}, 5), "linear M=16 N=13");
  EXPECT_EQ(machine({"--m", "16"}, 5), "linear M=16 N=12");
  EXPECT_EQ(machine({"--m", "16", "--n", "13"}, 5), "linear M=16 N=13");
}

TEST(Line, RunsOnTheMachineThatItsCodeIsFor) {
  expect_line(draw({"line", "--major", "27", "--code", "010100"}), 27, "010100", {6, 3});
  expect_line(draw({"line", "--major", "27", "--code", "00101000"}), 27, "00101000", {8, 5});
}

TEST(Line, OfNoStepsHasNoRows) {
  const Drawing d = draw({"line", "--major", "0", "--minor", "0"});
  EXPECT_EQ(d.csv, (std::vector<std::string>{"tick,major,minor"}));
  EXPECT_EQ(d.report["steps"], 0);
  EXPECT_EQ(d.report["max_deviation"], 0.0);
}

TEST(Line, TakesACodeInHexadecimal) {
  const Drawing d = draw({"line", "--major", "27", "--code", "0x0a"});
  expect_line(d, 27, "01010", {5, 2});
}

TEST(Line, TableShowsEveryClock) {
  const Ended ended =
      ends(0, cosim({"line", "--major", "27", "--minor", "9", "--code", "01010", "--table"}));
  // BP, UK, start, the first word formed, four words, the end: nine clocks and a heading.
  EXPECT_EQ(lines(ended.out).size(), 4U + 10U);
  expect_has(ended.out, {"01000101", "01000100", "01000000", "11100000"});
}

TEST(Line, HasAHelpThatNamesEveryOption) {
  expect_in(help({"line"}), {"--major BP", "--minor MP", "--code UK", "--m M", "--n N",
                             "--csv FILE", "tick,major,minor", "--report FILE", "--seed S"});
}

}  // namespace
}  // namespace cosim::cli
