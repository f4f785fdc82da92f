// A bench whose RTL is a queue in C++: what a verdict of it says of its streams, and of a run that
// is not the one that was judged.
#include "tb/stream/bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "model/core/input_error.h"
#include "tb/show/picture.h"
#include "tb/sim/report.h"
#include "tests/support/folder.h"
#include "tests/support/vcd.h"
#include "tests/tb/stream/queue.h"

namespace cosim {
namespace {

using test::Queue;
using QueueFault = test::Fault;

class QueueBench : public AnyStreamBench {
 public:
  QueueBench() {
    tables_.design = "queue";
    shape_.title = "queue";
    shape_.set_clocks("clk", "");
    shape_.watchdog = 50;
    shape_.pins = {clocked::pin::reset("rst")};
    const Field data{"data", 8, Format::bits, "", "", 0, "data"};
    shape_.add({.name = "x"}, true, {&data, 1});
    shape_.in.front().cases = {"even", "any", "never"};
    shape_.add({.name = "y"}, false, {&data, 1});
    for (Interface* i : {&shape_.in.front(), &shape_.out.front()}) {
      i->text = [](std::span<const Word> words) { return "<" + std::to_string(words[0]) + ">"; };
    }
    fill_tables();
  }
  std::unique_ptr<StreamDut> dut(std::uint32_t) const override {
    return std::make_unique<Queue>(instances++ == 0 ? first : later, 3);
  }
  std::unique_ptr<StreamDut> open_dut(std::uint32_t) const override {
    return std::make_unique<Queue>(shown, 3);
  }
  void expect(const std::vector<Sequence>& given, std::vector<Sequence>& all) const override {
    all.assign(1, Sequence(1));
    for (std::size_t n = 0; n < given[0].size() && !is_mute; ++n) {
      const Word right = low_bits(given[0][n][0] + 1, 8);
      all[0].push({&right, 1});
    }
  }
  StreamSizes sizes(const std::vector<Sequence>&) const override {
    return [](std::span<const std::size_t> taken, std::span<std::size_t> sizes) {
      sizes[0] = taken[0];
    };
  }
  const char* broken_rule(std::size_t, std::span<const Word>) const override { return nullptr; }
  std::string state_after(const std::vector<Sequence>& given) const override {
    return std::to_string(given[0].size()) + " taken";
  }
  void count_cases(bool goes_in, std::size_t, const Sequence& some, std::size_t n,
                   std::span<std::uint64_t> hits) const override {
    ASSERT_TRUE(goes_in);
    for (std::size_t i = 0; i < n; ++i) {
      hits[0] += some[i][0] % 2 == 0 ? 1 : 0;
      hits[1] += 1;
    }
  }

  Stimulus ten() const {
    Stimulus s;
    s.machine = title();
    for (Word n = 0; n < 10; ++n) s.clocks.push_back({1, 0, n, 0, 0});
    return s;
  }

  /// Of the first instance, of those behind it, and of those that show their hierarchy.
  QueueFault first = QueueFault::none, later = QueueFault::none, shown = QueueFault::none;
  bool is_mute = false;  ///< the model gives nothing
  mutable int instances = 0;
};

Outcome outcome_of(const AnyBench& bench, Run run) {
  return {&bench, "ten", result_of(std::move(run), {}, "ten")};
}

TEST(StreamBench, CountsWhatWentInCameOutAndWasCompared) {
  const QueueBench bench;
  const std::vector<Outcome> all{outcome_of(bench, bench.replay(bench.ten(), {})),
                                 outcome_of(bench, bench.replay(bench.ten(), {}))};
  EXPECT_EQ(all[0].result.streams, (std::vector<Transactions>{{10, 0}, {10, 10}}));
  const std::string text = comparison_text(all) + verdict_text(all);
  EXPECT_NE(text.find("\ntransactions: x: 20 in; y: 20 out, 20 compared\ncases: 2 of 3 happened\n"),
            std::string::npos)
      << text;
  const auto report = nlohmann::json::parse(report_json({all[0]}, 1));
  EXPECT_EQ(report["streams"],
            nlohmann::json::parse(R"({"x": {"in": 10}, "y": {"out": 10, "compared": 10}})"));
}

// Several cases share the clocks of one hostile case.
TEST(StreamBench, CountsAllCasesOfASweep) {
  const QueueBench bench;
  const cosim::Run run = bench.run_hostile({1, 0, 1000});
  const cosim::Run first = bench.replay(draw_stream_case(bench.shape(), 1, 0, 1000, {}), {});
  ASSERT_FALSE(run.mismatch);
  ASSERT_LT(first.clocks, run.clocks);
  for (const std::size_t s : {0U, 1U}) EXPECT_GT(run.streams[s].moved, first.streams[s].moved);
  EXPECT_EQ(run.streams[1].moved, run.streams[1].compared);
}

TEST(StreamBench, CountsTheCasesOfWhatWentIn) {
  const QueueBench bench;
  const cosim::Run run = bench.run_hostile({1, 0, 1000});
  ASSERT_EQ(run.happened.size(), 3U);
  EXPECT_EQ(run.happened[1], run.streams[0].moved);
  EXPECT_GT(run.happened[0], 0U);
  EXPECT_LT(run.happened[0], run.happened[1]);
  const std::vector<Outcome> all{outcome_of(bench, run)};
  EXPECT_NE(comparison_text(all).find("\ncases: 2 of 3 happened\nnever happened: x: never\n"),
            std::string::npos)
      << comparison_text(all);
  const auto report = nlohmann::json::parse(report_json(all, 1));
  EXPECT_EQ(report["cases"]["x: any"], run.happened[1]);
  EXPECT_EQ(report["cases"]["x: never"], 0);
}

TEST(StreamBench, TellsAFailureInTheWordsOfItsModel) {
  QueueBench bench;
  bench.first = bench.later = QueueFault::value;
  const cosim::Run run = bench.replay(bench.ten(), {});
  ASSERT_TRUE(run.mismatch);
  const auto& told = run.mismatch->told;
  ASSERT_GE(told.size(), 4U);
  EXPECT_NE(std::ranges::find(told, "x number 3: <3>"), told.end());
  EXPECT_NE(std::ranges::find(told, "expected y number 3: <4>"), told.end());
  EXPECT_NE(std::ranges::find(told, "actual   y number 3: <0>"), told.end());
  EXPECT_NE(told.back().find(" taken"), std::string::npos);
  EXPECT_NE(difference_text(*run.mismatch).find("\n  x number 3: <3>\n"), std::string::npos);
}

// Number 3 is wrong in a field that means nothing there; number 4 is not.
TEST(StreamBench, LeavesOutWhatIsNotCompared) {
  class Conditional : public QueueBench {
   public:
    Conditional() {
      shape_.out.front().compares = [](std::span<const Word> y, std::size_t) { return y[0] != 4; };
    }
  } bench;
  bench.first = bench.later = QueueFault::value;
  EXPECT_FALSE(bench.replay(bench.ten(), {}).mismatch);
  Stimulus other = bench.ten();
  other.clocks[3][2] = 7;
  EXPECT_TRUE(bench.replay(other, {}).mismatch);
}

TEST(StreamBench, WritesTheWordsOfItsModelIntoTheWave) {
  class Sink final : public WaveSink {
   public:
    void begin(const WaveShape& shape, const WaveRange&, const std::vector<Signal>&) override {
      names = shape.texts;
    }
    void clock(const WaveClock& now) override {
      for (std::size_t i = 0; i < names.size(); ++i) texts.insert(names[i] + now.texts[i]);
    }
    void end(const WaveRange&) override {}
    std::vector<std::string> names;
    std::set<std::string> texts;
  } sink;
  QueueBench bench;
  bench.first = bench.later = bench.shown = QueueFault::value;
  bench.show(bench.ten(), {}, sink);
  EXPECT_EQ(sink.names, (std::vector<std::string>{"x", "y", "expected_y"}));
  for (const char* text : {"x<3>", "y<0>", "expected_y<4>", "y-"}) {
    EXPECT_TRUE(sink.texts.contains(text)) << text;
  }
  if (!test::can_read_waves()) GTEST_SKIP() << "there is no fst2vcd";
  const test::Folder folder;
  const std::string path = folder.path("x.fst");
  bench.draw_wave(path, bench.ten(), {});
  const std::uint64_t clock = bench.replay(bench.ten(), {}).mismatch->clock;
  EXPECT_EQ(test::Vcd(path).at("cosim.text.y", 10 * clock + 1), "<0>");
  EXPECT_EQ(test::Vcd(path).at("cosim.text.expected_y", 10 * clock + 1), "<4>");
  EXPECT_NE(folder.text("x.gtkw").find("\n+{y} cosim.text.y\n"), std::string::npos);
}

TEST(StreamBench, ThatComparesNothingDoesNotMatch) {
  QueueBench bench;
  bench.is_mute = true;
  Stimulus none = bench.ten();
  for (auto& row : none.clocks) row[0] = 0;
  const Outcome outcome = outcome_of(bench, bench.replay(none, {}));
  ASSERT_TRUE(outcome.result.match());
  EXPECT_TRUE(compared_nothing(outcome));
  EXPECT_EQ(nothing_text(outcome),
            "queue: nothing was compared: x: 0 in; y: 0 out, 0 compared; --allow-nothing-compared "
            "makes that no error");
  EXPECT_EQ(verdict_of({outcome}), "nothing compared");
  EXPECT_EQ(nlohmann::json::parse(report_json({outcome}, 1))["verdict"], "nothing compared");
  EXPECT_NE(comparison_text({outcome}).find("never compared: y, "), std::string::npos);
}

TEST(StreamBench, WhoseWaveIsOfAnotherRunSaysSo) {
  const auto said = [](const QueueBench& bench) {
    PictureSink sink;
    testing::internal::CaptureStderr();
    bench.show(bench.ten(), {}, sink);
    return testing::internal::GetCapturedStderr();
  };
  QueueBench bench;
  EXPECT_EQ(said(bench), "");
  bench.shown = QueueFault::value;
  EXPECT_NE(said(bench).find(
                "queue: the wave is of another run than the verdict: in the wave y_data fails on "
                "clock 4, in the run that was judged 10 transactions match: "),
            std::string::npos);
  bench.first = bench.later = QueueFault::value;
  EXPECT_EQ(said(bench), "");
  bench.shown = QueueFault::none;
  EXPECT_NE(said(bench), "");
}

// The watchdog finds a silence long after the clock on which nothing moves any more.
TEST(StreamBench, WhoseSilenceIsLongerThanItsWaveIsKeptAndShown) {
  class Patient : public QueueBench {
   public:
    Patient() { shape_.watchdog = 500; }
  } bench;
  bench.first = bench.later = bench.shown = QueueFault::hang;
  const cosim::Run run = bench.replay(bench.ten(), {.before = 20, .after = 5});
  ASSERT_TRUE(run.mismatch);
  PictureSink sink;
  testing::internal::CaptureStderr();
  bench.show(bench.ten(), {.before = 20, .after = 5}, sink);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(StreamBench, WhoseFailureIsAnotherOneTheNextTimeIsRefused) {
  for (const QueueFault next : {QueueFault::none, QueueFault::twice}) {
    QueueBench bench;
    bench.first = QueueFault::value;
    bench.later = next;
    EXPECT_THROW(bench.replay(bench.ten(), {}), InputError);
    bench.instances = 0;
    EXPECT_THROW(bench.run_hostile({1, 0, 1000}), InputError);
  }
}

}  // namespace
}  // namespace cosim
