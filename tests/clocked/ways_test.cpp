// What stops an exporter, and what merge() and known conditions spare it.
#include <gtest/gtest.h>

#include "model/clocked/export.h"

namespace cosim::clocked::test {
namespace {

// N conditions behind each other that have nothing to do with each other.
template <int N>
struct Chain {
  struct In {
    UInt<N> set;
  };
  struct Out {
    UInt<8> count;
  };
  UInt<8> count = 0;
  Out clock(const In& in) {
    for (int i = 0; i < N; ++i) {
      if (in.set[i]) count = count * 3 + i;
    }
    return {.count = count};
  }
};

std::string error_of(Exported (*run)(const std::string&)) {
  try {
    run("chain");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ClockedWays, AreOneForEachChoice) { EXPECT_EQ(exported<Chain<5>>("chain").ways, 32U); }

// The words of their comments: what each is, from its kind on.
std::vector<std::string> points_of(const Exported& file) {
  std::vector<std::string> all;
  std::istringstream lines(file.text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("; ways:")) all.push_back(line.substr(line.find('\t') + 1));
  }
  return all;
}

TEST(ClockedWays, EachHasTheLineOfItsLastCondition) {
  const auto points = points_of(exported_ways<Chain<5>>("chain"));
  EXPECT_EQ(points.size(), 32U);
  for (const std::string& point : points) {
    EXPECT_TRUE(point.starts_with("way\t/")) << point;
    EXPECT_NE(point.find("/ways_test.cpp\t21\t"), std::string::npos) << point;
    EXPECT_NE(point.find(": if (in.set[i]) count = count * 3 + i; after 21 "), std::string::npos)
        << point;
  }
}

TEST(ClockedWays, TooManyToListAreBranches) {
  const auto points = points_of(exported_ways<Chain<9>>("chain"));
  ASSERT_EQ(points.size(), 2U);
  EXPECT_TRUE(points[0].starts_with("branch\t/")) << points[0];
  EXPECT_TRUE(points[0].ends_with("\t21\tfalse: if (in.set[i]) count = count * 3 + i"));
  EXPECT_TRUE(points[1].ends_with("\t21\ttrue: if (in.set[i]) count = count * 3 + i"));
}

TEST(ClockedWays, TooManyNameTheLineThatForksMost) {
  ways.most_ways = 1000;
  const std::string error = error_of(exported<Chain<20>>);
  ways.most_ways = 1'000'000;
  EXPECT_NE(error.find("chain: 1001 ways"), std::string::npos) << error;
  EXPECT_NE(error.find("ways_test.cpp:21 forks most"), std::string::npos) << error;
}

struct Endless {
  struct In {
    UInt<8> n;
  };
  struct Out {
    UInt<8> n;
  };
  Out clock(const In& in) {
    UInt<8> n = in.n;
    while (n != 5) n = n * n + in.n;
    return {.n = n};
  }
};

TEST(ClockedWays, ALoopWithoutAnEndIsStopped) {
  EXPECT_NE(error_of(exported<Endless>).find("forks most"), std::string::npos);
}

struct Restless {
  struct In {
    UInt<8> n;
  };
  struct Out {
    UInt<8> n;
  };
  Out clock(const In& in) {
    static int called = 0;
    if (in.n == ++called) return {.n = 1};
    return {.n = 2};
  }
};

TEST(ClockedWays, AModelThatRemembersElsewhereIsRefused) {
  EXPECT_NE(error_of(exported<Restless>).find("clock() is not the same"), std::string::npos);
}

// A condition that follows from those of its way is none.
struct Known {
  struct In {
    UInt<8> n;
    Bit a, b;
  };
  struct Out {
    UInt<8> n;
  };
  Out clock(const In& in) const {
    UInt<8> n = 0;
    if (in.n == 3) n = 1;
    if (in.n == 4) n = 2;  // not where it is 3
    if (in.a && in.b) n += 4;
    if (in.a && in.b && in.n == 3) n += 8;
    return {.n = n};
  }
};

TEST(ClockedWays, WhatFollowsFromOthersDoesNotFork) {
  EXPECT_EQ(exported<Known>("known").ways, 6U);
}

}  // namespace
}  // namespace cosim::clocked::test
