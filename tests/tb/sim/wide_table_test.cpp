// The table of a difference in a design of many signals: what changes around it, and how much was
// left out.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tb/sim/mismatch.h"

namespace cosim {
namespace {

constexpr std::size_t kClocks = 13, kAt = 8;

// Of `signals` registers s0, s1, ... the first changes on each clock, the second on the first clock
// alone, and the last is wrong from the clock kAt on.
Mismatch of(const std::vector<std::string>& names) {
  Mismatch m;
  m.first = 100;
  m.clock = m.first + kAt;
  for (std::size_t s = 0; s < names.size(); ++s) {
    Trace t{{names[s].c_str(), 8, Format::number, "", ""}, Trace::Kind::reg, {}, {}};
    for (std::size_t c = 0; c < kClocks; ++c) {
      t.expected.push_back(s == 0 ? static_cast<Word>(c) : s == 1 && c == 0 ? 7 : 0);
      t.actual.push_back(s + 1 == names.size() && c >= kAt ? 1 : t.expected.back());
    }
    m.traces.push_back(t);
  }
  return m;
}
std::vector<std::string> named(std::size_t signals) {
  std::vector<std::string> names;
  for (std::size_t s = 0; s < signals; ++s) names.push_back("s" + std::to_string(s));
  return names;
}
std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(WideTable, ShowsWhatChangesAroundTheDifference) {
  const auto names = named(60);
  EXPECT_EQ(table_text(of(names)),
            "  clock             105  106  107  >108  109\n"
            "  reg s0              5    6    7     8    9\n"
            "  reg s59 expected    0    0    0     0    0\n"
            "  reg s59 actual      0    0    0    1!   1!\n"
            "  left out: 8 clocks, and 58 signals that do not change here; a wave has all\n");
}

TEST(WideTable, ShowsAllOfFew) {
  const auto names = named(40);
  const std::string text = table_text(of(names));
  EXPECT_EQ(lines(text), 42);  // with the clocks, and two rows of the last
  EXPECT_EQ(text.find("left out"), std::string::npos);
}

}  // namespace
}  // namespace cosim
