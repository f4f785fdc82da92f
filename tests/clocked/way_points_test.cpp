// The ways through a model, as its exporter wrote them, on drawn states and inputs.
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "tb/util/read_file.h"
#include "tb/util/words.h"
#include "tests/clocked/compare.h"
#include "tests/clocked/models.h"

namespace cosim::clocked::test {
namespace {

struct WayInFile {
  std::string kind, what;
};
std::vector<WayInFile> ways_of(const std::string& name) {
  std::vector<WayInFile> all;
  for (const std::string& line : lines_in(read_file(COSIM_EXPORTED "/" + name + ".ways.btor2"))) {
    if (!line.starts_with("; ways:")) continue;
    const auto words = parts_in(line, '\t');
    EXPECT_EQ(words.size(), 5U) << line;
    all.push_back({words.at(1), words.at(4)});
  }
  return all;
}

/// Draws clocks: look(model, in, which), the ways that the clock takes by their numbers.
template <class Model, class Look>
void draw_clocks(const std::string& name, int clocks, const Look& look) {
  Netlist netlist = exported(name + ".ways");
  Random random(1);
  for (int n = 0; n < clocks && !testing::Test::HasFatalFailure(); ++n) {
    std::vector<Wide> from;
    auto in = zero<typename Model::In>();
    Model model{};
    draw(random, in, from);
    draw(random, model, from);
    netlist.run(from);
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < netlist.said.size(); ++i) {
      if (netlist.value(netlist.said[i].node) != Wide(0)) which.push_back(i);
    }
    look(model, in, which);
  }
}

TEST(ClockedWayPoints, EachClockTakesOne) {
  for_each_model([]<class Model>(const std::string& name) {
    SCOPED_TRACE(name);
    const auto ways = ways_of(name);
    std::set<std::string> words;
    std::size_t listed = 0;
    for (const WayInFile& way : ways) {
      words.insert(way.kind + way.what);
      listed += way.kind == "way" ? 1U : 0U;
    }
    EXPECT_EQ(words.size(), ways.size()) << "two have the same words";
    if (listed == 0) return;
    draw_clocks<Model>(name, 1000, [&](const auto&, const auto&, const auto& which) {
      const auto taken = std::count_if(which.begin(), which.end(),
                                       [&](std::size_t i) { return ways.at(i).kind == "way"; });
      ASSERT_EQ(taken, 1);
    });
  });
}

// "after 26 false, 28 true" with names for the lines.
std::string with_names(std::string what, const std::string& text) {
  const auto lines = lines_in(text);
  const std::pair<const char*, const char*> names[] = {
      {"if (in.rst)", "RST"}, {"if (in.pays)", "PAYS"}, {"if (paid >= 20)", "PAID"}};
  for (const auto& [condition, name] : names) {
    std::size_t line = 0;
    while (lines.at(line).find(condition) == std::string::npos) ++line;
    const std::string number = ' ' + std::to_string(line + 1) + ' ';
    const std::size_t at = what.find(number, what.find("; after "));
    if (at != std::string::npos) what.replace(at + 1, number.size() - 2, name);
  }
  return what;
}

TEST(ClockedWayPoints, AreThoseToldByHand) {
  const std::string text = read_file(COSIM_SOURCE "/tests/clocked/turnstile.h");
  const auto ways = ways_of("turnstile");
  std::set<std::string> taken;
  draw_clocks<Turnstile>("turnstile", 10000,
                         [&](const Turnstile& model, const auto& in, auto which) {
                           ASSERT_EQ(which.size(), 1U);
                           const std::string what = with_names(ways.at(which[0]).what, text);
                           ASSERT_EQ(what, model.way(in));
                           taken.insert(what);
                         });
  EXPECT_EQ(taken.size(), ways.size());
  EXPECT_EQ(ways.size(), 6U);
}

// Each of the 60 conditions in a block of merge() is one line: whether it is asked and what it is.
TEST(ClockedWayPoints, ConditionsInABlockAreBranches) {
  const auto ways = ways_of("valid_60");
  draw_clocks<Valid<60>>(
      "valid_60", 1000, [&](const auto& model, const auto& in, const auto& which) {
        std::set<std::string> expected{in.rst ? "true: if (in.rst) *this = Valid{}"
                                              : "false: if (in.rst) *this = Valid{}"};
        for (int i = 0; i < 60; ++i) {
          const bool sets = in.set[i] && !model.valid[i], clears = in.clear[i] && model.valid[i];
          expected.insert(std::string(sets ? "true" : "false") + ": if (in.set[i] && !valid[i])");
          if (!sets)
            expected.insert(std::string(clears ? "true" : "false") +
                            ": else if (in.clear[i] && valid[i])");
        }
        std::set<std::string> taken;
        for (const std::size_t i : which) taken.insert(ways.at(i).what);
        ASSERT_EQ(taken, expected);
      });
}

}  // namespace
}  // namespace cosim::clocked::test
