// The benches that are built, and what a session on one says of its clocks.
#include <gtest/gtest.h>

#include <fstream>
#include <map>

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
  EXPECT_EQ(benches_of<linear::Design>().size() + benches_of<circular::Design>().size() +
                benches_of<dda::Design>().size(),
            lines.size());
}

struct Expected {
  std::size_t registers, outputs, inputs;
  const char *first_register, *first_output, *source;
};

TEST(Benches, CompareRegistersThenOutputs) {
  const std::map<std::string, Expected> designs = {
      {"linear", {9, 4, 6, "trigger30", "busy", "SU 1631518"}},
      {"circular", {5, 3, 8, "t4", "running", "SU 1665343"}},
      {"dda", {15, 7, 6, "running", "busy", "the method of differential increments"}}};
  for (const auto& bench : benches()) {
    const std::vector<Field> compared = bench->compared();
    const Expected& expected = designs.at(bench->design());
    ASSERT_EQ(bench->registers(), expected.registers);
    ASSERT_EQ(compared.size(), expected.registers + expected.outputs);
    EXPECT_STREQ(compared.front().name, expected.first_register);
    EXPECT_STREQ(compared[bench->registers()].name, expected.first_output);
    EXPECT_EQ(bench->inputs().size(), expected.inputs);
    EXPECT_EQ(bench->source(), expected.source);
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
      EXPECT_EQ(recorder.clocks.front().registers.f, 3);
    }
  }
}

TEST(Session, DrawsOnWhereItStopped) {
  const auto& bench = model_bench<circular::Design, circular::Params{4}>();
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
