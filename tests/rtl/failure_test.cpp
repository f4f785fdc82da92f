// What a planted fault leaves behind: the folder is whole, its wave shows the difference where an
// independent run finds it, and the smallest stimulus is small, fails there and not on good RTL.
// Needs: circular
#include "tb/sim/failure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <thread>

#include "tb/show/view.h"
#include "tb/sim/replay.h"
#include "tb/sim/stimulus_text.h"
#include "tb/util/read_file.h"
#include "tests/rtl/planted.h"
#include "tests/rtl/straight.h"
#include "tests/support/designs.h"
#include "tests/support/explain.h"
#include "tests/support/folder.h"
#include "tests/support/vcd.h"

namespace cosim::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kCases = 100;
constexpr double kSeconds = 0.5;  // a hundredth is usual; the sanitizers take several times that

// The RTL as shipped, of the same parameters.
template <class Design>
const AnyBench* shipped_for(const AnyBench& bench) {
  for (const auto& v : variants<Design>()) {
    if (v.name.starts_with("shipped/") && v.bench->title() == bench.title()) {
      return v.bench.get();
    }
  }
  return nullptr;
}

std::string bits(Word value, int width) {
  std::string text;
  for (int i = width - 1; i >= 0; --i) text += (value >> i & 1) != 0 ? '1' : '0';
  return text;
}

// The wave has the difference at its clock and none before, with the values of either side.
void expect_wave(const fs::path& file, const AnyBench& bench, const Difference& first) {
  const Vcd wave(file.string());
  const std::uint64_t time = first.clock * wave_period;
  for (const Field& f : bench.compared()) {
    if (f.name != first.signal) continue;
    EXPECT_EQ(wave.at("cosim.expected." + first.signal, time), bits(first.expected, f.width));
    EXPECT_EQ(wave.at("cosim.actual." + first.signal, time), bits(first.actual, f.width));
  }
  EXPECT_EQ(wave.at("cosim.mismatch." + first.signal, time), "1");
  EXPECT_EQ(wave.at("cosim.mismatch.any", time), "1");
  if (first.clock > 0) EXPECT_EQ(wave.at("cosim.mismatch.any", time - 1), "0");
  EXPECT_EQ(wave.at("cosim.clock", time), bits(static_cast<Word>(first.clock), clock_width));
  EXPECT_TRUE(wave.has(bench.design() + ".clk")) << "no RTL in the wave";
}

template <class Design>
void expect_failure_explained(const Variant<Design>& variant) {
  const Bench<Design>& bench = *variant.bench;
  std::optional<Mismatch> found;
  for (std::uint64_t i = 0; i < kCases && !found; ++i) {
    found = bench.run_hostile({1, i, 1000}).mismatch;
  }
  ASSERT_TRUE(found) << variant.what;

  const Folder temporary;
  const std::clock_t began = std::clock();
  const Failure failure = leave_failure(bench, "hostile", *found, {temporary.path(""), {}});
  const auto took = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  testing::Test::RecordProperty("seconds", std::to_string(took));
  EXPECT_LT(took, kSeconds) << "of the processor";
  for (const char* name : {"report.txt", "report.json", "report.html", "wave.gtkw",
                           "wave.phase.txt", "wave.step.txt", "smallest.gtkw"}) {
    EXPECT_GT(fs::file_size(failure.folder / name), 0U) << name;
  }

  using Pair = std::pair<std::string, const char*>;
  for (const auto& [name, wave] :
       {Pair{"stimulus", "wave.fst"}, Pair{"smallest", "smallest.fst"}}) {
    const std::string text = read_file((failure.folder / (name + ".stim")).string());
    std::vector<std::unique_ptr<AnyBench>> one;
    one.push_back(variant.make_bench());
    const Stimulus s = parse_stimulus(name, text, one).stimulus;
    const auto first =
        straight_run(variant, script_of<Design>(Rows<Design>(bench.params(), s)), s.power_up);
    ASSERT_TRUE(first) << name << " does not fail";
    EXPECT_EQ(reported(bench.replay(s)), first) << name;
    if (can_read_waves()) expect_wave(failure.folder / wave, bench, *first);
    if (name == "stimulus") {
      EXPECT_EQ(first->clock, found->clock);
      EXPECT_EQ(first->signal, found->signal);
      continue;
    }
    EXPECT_LE(s.clocks.size(), most_clocks_shrunk);
    testing::Test::RecordProperty("clocks", std::to_string(s.clocks.size()));
    const AnyBench* shipped = shipped_for<Design>(bench);
    ASSERT_NE(shipped, nullptr) << "nothing to compare with at " << bench.title();
    EXPECT_EQ(shipped->first_difference(s), std::nullopt) << "fails on good RTL";
  }
}

template <class Design>
void add_subjects(std::vector<Subject>& all) {
  for (const auto& v : variants<Design>()) {
    if (!is_planted(v.name)) continue;
    std::string name = Design::name + ("_" + v.name);
    std::replace(name.begin(), name.end(), '/', '_');
    all.push_back({name, [&v] { expect_failure_explained(v); }});
  }
}

std::vector<Subject> subjects() {
  std::vector<Subject> all;
  for_each_design([&]<class Design>() { add_subjects<Design>(all); });
  return all;
}

class Failures : public testing::TestWithParam<Subject> {};
TEST_P(Failures, AreExplained) { GetParam().check(); }
INSTANTIATE_TEST_SUITE_P(Planted, Failures, testing::ValuesIn(subjects()), name_of_subject);

Mismatch a_mismatch() {
  for (const auto& v : variants<circular::Design>()) {
    if (!v.name.starts_with("faults/")) continue;
    for (std::uint64_t i = 0; i < kCases; ++i) {
      if (auto found = v.bench->run_hostile({1, i, 1000}).mismatch) return *found;
    }
  }
  throw std::runtime_error("no planted fault is found");
}

TEST(FailureFolder, IsLeftByATest) {
  const Mismatch m = a_mismatch();
  const Folder temporary;
  ASSERT_EQ(setenv("COSIM_FAILURES", temporary.path("").c_str(), 1), 0);
  const fs::path folder = temporary.path(failure_name(*m.bench, "FailureFolder.IsLeftByATest"));
  const std::string text = explain(m);
  EXPECT_TRUE(text.starts_with(to_text(m)));
  EXPECT_NE(text.find("cosim replay " + folder.string() + '\n'), std::string::npos) << text;
  EXPECT_TRUE(fs::exists(folder / "report.txt"));
}

TEST(FailureFolder, ThatCannotBeWrittenIsSaid) {
  const Mismatch m = a_mismatch();
  ASSERT_EQ(setenv("COSIM_FAILURES", "/dev/null/x", 1), 0);
  EXPECT_NE(explain(m).find("no failure folder: /dev/null/x"), std::string::npos);
}

// Each puts its own in the place of the other's.
TEST(FailureFolder, MayBeLeftBySeveralAtOnce) {
  const Mismatch m = a_mismatch();
  const Folder temporary;
  const auto leave = [&] {
    for (int i = 0; i < 10; ++i) leave_failure(*m.bench, "case", m, {temporary.path(""), {}});
  };
  { const std::jthread one(leave), two(leave); }
  const std::string name = failure_name(*m.bench, "case");
  EXPECT_EQ(temporary.names(), std::vector<std::string>{name});
  EXPECT_EQ(std::distance(fs::directory_iterator(temporary.path(name)), {}), 14);
}

}  // namespace
}  // namespace cosim::test
