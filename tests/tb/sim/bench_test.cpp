// The benches that are built, and what a session on one says of its clocks.
// Needs: linear, circular
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <span>

#include "tb/util/pattern.h"
#include "tests/designs/circular/records.h"
#include "tests/support/designs.h"
#include "tests/support/model_adapter.h"
#include "tests/support/recorder.h"
#include "tests/support/root.h"
#include "tests/tb/shape.h"

namespace cosim::test {
namespace {

TEST(Benches, AreTheLinesOfShippedTxt) {
  std::ifstream file(project_root() / "rtl" / "shipped.txt");
  ASSERT_TRUE(file);
  std::vector<std::string> lines, titles;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with('#') && !line.empty()) lines.push_back(line);
  }
  for (const auto& bench : benches()) titles.push_back(bench->title());
  EXPECT_EQ(titles, lines);
  std::size_t typed = 0;
  for_each_design([&]<class Design>() { typed += benches_of<Design>().size(); });
  EXPECT_EQ(typed, lines.size());
}

using Names = std::set<std::string>;

// What the text of a design has: nets of any of its modules whose names end in _q; outputs and
// inputs of its top module.
struct Text {
  Names registers, outputs, inputs;
};

Text read_text(const std::string& design) {
  const Pattern port(R"(^\s*(input|output)\s+wire\s*(\[.*\])?\s*(\w+))");
  const Pattern net(R"(\b\w+_q\b)");
  Text text;
  for (const auto& entry : std::filesystem::directory_iterator(project_root() / "rtl" / design)) {
    const bool is_top = entry.path().stem() == design;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      line.resize(std::min(line.find("//"), line.size()));
      for (const auto& found : is_top ? port.all(line) : std::vector<Pattern::Parts>{}) {
        (found[1] == "input" ? text.inputs : text.outputs).insert(found[3]);
      }
      for (const auto& found : net.all(line)) text.registers.insert(found[0]);
    }
  }
  return text;
}

// A register's own name, without the path of its module.
Names own_names_of(std::span<const Field> registers) {
  Names names;
  for (const Field& f : registers) {
    const std::string net = f.net;
    names.insert(net.substr(net.rfind('.') + 1));
  }
  return names;
}

template <class Fields>
Names names_of(const Fields& begin, const Fields& end) {
  Names names;
  for (auto at = begin; at != end; ++at) names.insert(at->name);
  return names;
}

TEST(Benches, CompareEveryRegisterOfTheRtlThenEveryOutput) {
  for (const auto& bench : benches()) {
    const Text text = read_text(bench->design());
    const std::vector<Field> compared = bench->compared(), inputs = bench->inputs();
    const auto outputs = compared.begin() + static_cast<std::ptrdiff_t>(bench->registers());
    EXPECT_EQ(own_names_of({compared.begin(), outputs}), text.registers) << bench->title();
    EXPECT_EQ(names_of(outputs, compared.end()), text.outputs) << bench->title();
    Names driven = names_of(inputs.begin(), inputs.end());
    driven.insert("clk");
    EXPECT_EQ(driven, text.inputs) << bench->title();
  }
}

// Power-up states are random and gone after the first clock.
TEST(Benches, DrawTheSameFromAnyPowerUp) {
  const std::vector<circular::Arc> arcs = {{{12, 0}, 144, {}}};
  for (const auto* bench : benches_of<circular::Design>()) {
    for (std::uint32_t power_up = 0; power_up < 50; ++power_up) {
      Recorder<circular::Design> recorder;
      const auto run = bench->open(power_up)->draw(arcs, recorder);
      ASSERT_FALSE(run.mismatch) << explain(*run.mismatch);
      ASSERT_EQ(recorder.clocks.size(), 21U);
      EXPECT_EQ(circular::named<circular::Held>(recorder.clocks.front().registers).f, 3);
    }
  }
}

TEST(Session, DrawsOnWhereItStopped) {
  const auto& bench = model_bench<circular::Design, circular::of_width(4)>();
  const std::vector<circular::Arc> arcs = {{{12, 0}, 144, {}}, {{8, 9}, 144, {}}};
  const auto session = bench.open(1);
  for (int i = 0; i < 3; ++i) {
    Recorder<circular::Design> recorder;
    const auto run = session->draw(arcs, recorder);
    EXPECT_FALSE(run.mismatch);
    EXPECT_EQ(run.clocks, 21U + 11);  // of this call
    ASSERT_EQ(recorder.clocks.size(), 21U + 11);
    EXPECT_EQ(recorder.clocks.front().job, 0U);
    EXPECT_EQ(recorder.clocks.back().job, 1U);
  }
}

TEST(Session, DrawsNothingInNoTime) {
  for (const auto* bench : benches_of<linear::Design>()) {
    EXPECT_TRUE(draw(*bench, {}).empty());
  }
}

}  // namespace
}  // namespace cosim::test
