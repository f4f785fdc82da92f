// Each fault that a stream can have is found, and said by its name.
#include "tb/stream/runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "tb/stream/own_of.h"
#include "tests/tb/stream/queue.h"

namespace cosim {
namespace {

using test::Fault, test::Queue;

struct Setting {
  Fault fault = Fault::none;
  std::uint64_t number = 3;
  Word stall = 0;  ///< of each value that comes out
  int latency = 1;
  Word waits = 0;  ///< ready of each waits for valid
  bool steady = false;
  bool twofold = false;  ///< a second stream comes out, z, which is y where nothing waits
};

class Case {
 public:
  explicit Case(const Setting& s) : setting_(s) {
    shape_.title = "queue";
    shape_.set_clocks("clk", "");
    shape_.watchdog = 50;
    shape_.pins = {clocked::pin::reset("rst")};
    const Field data{"data", 8, Format::bits, "", "", 0, "data"};
    shape_.add({.name = "x"}, true, {&data, 1});
    shape_.add({.name = "y", .latency = s.latency, .steady = s.steady}, false, {&data, 1});
    if (s.twofold) shape_.add({.name = "z", .has_ready = false}, false, {&data, 1});
    given_.given.emplace_back(1);
    given_.in.emplace_back();
    given_.out.resize(shape_.out.size());
    for (Word n = 0; n < 10; ++n) {
      const Word in = n * 7, out = n * 7 + 1;
      given_.given[0].push({&in, 1});
      given_.in[0].stalls.push_back(0);
      given_.out[0].stalls.push_back(s.stall);
      given_.out[0].waits.push_back(s.waits);
      expected_[0].push({&out, 1});
    }
    expected_.resize(shape_.out.size(), expected_[0]);
  }

  StreamResult run(std::uint64_t budget = 100000) {
    Queue queue(setting_.fault, setting_.number);
    return StreamRunner(shape_, queue).run(order(budget));
  }
  /// How often it was asked what is due.
  int asked() const { return asked_; }
  std::string says() {
    const StreamResult result = run();
    return result.finding ? to_text(shape_, order(100000), result) : "nothing";
  }

 private:
  StreamOrder order(std::uint64_t budget) {
    const auto due = [this](std::span<const std::size_t> taken, std::span<std::size_t> sizes) {
      ++asked_;
      std::copy(taken.begin(), taken.end(), sizes.begin());
    };
    return {given_, expected_, due, 1, budget, true, nullptr};
  }
  Setting setting_;
  int asked_ = 0;
  StreamShape shape_;
  StreamCase given_;
  std::vector<Sequence> expected_{Sequence(1)};
};

TEST(StreamRun, AQueueThatDoesItRightPassesWithAndWithoutStalls) {
  for (const Word stall : {0, 1, 7}) {
    Case c({.stall = stall, .steady = true});
    const StreamResult result = c.run();
    EXPECT_FALSE(result.finding) << stall;
    EXPECT_EQ(result.streams.back().compared, 10U);
    // One clock each and its stall, one before the first, and some behind the last.
    EXPECT_GE(result.clocks, 10 * (1 + static_cast<std::uint64_t>(stall)) + 17);
  }
}

TEST(StreamRun, EachOfTwoStreamsIsTaken) {
  const StreamResult result = Case({.twofold = true}).run();
  EXPECT_FALSE(result.finding);
  EXPECT_EQ(result.streams[1].compared, 10U);
  EXPECT_EQ(result.streams[2].compared, 10U);
}

TEST(StreamRun, AnotherValueIsFoundWhereItIs) {
  Case c({.fault = Fault::value});
  const auto result = c.run();
  ASSERT_TRUE(result.finding);
  EXPECT_EQ(result.finding->number, 3U);
  EXPECT_EQ(result.finding->clock, 4U);  // taken on clock 3
  EXPECT_EQ(c.says(), "another value: y number 3");
}

TEST(StreamRun, LostDoubledReorderedAndExtraAreSaidByTheirNames) {
  EXPECT_EQ(Case({.fault = Fault::lose}).says(), "lost: y number 3; number 4 comes instead");
  EXPECT_EQ(Case({.fault = Fault::twice}).says(), "doubled: y number 4 is number 3 again");
  EXPECT_EQ(Case({.fault = Fault::swap}).says(), "reordered: y number 3 comes after number 4");
  EXPECT_EQ(Case({.fault = Fault::extra}).says(),
            "extra: a value that is not expected comes before y number 3");
}

TEST(StreamRun, OneTooManyAtTheEndIsFoundAndMayBeTheLastOneAgain) {
  EXPECT_EQ(Case({.fault = Fault::twice, .number = 9}).says(),
            "doubled: y number 10 is number 9 again; 10 transactions expected");
  EXPECT_EQ(Case({.fault = Fault::extra_last, .number = 9}).says(),
            "extra: y number 10 comes; 10 transactions expected");
}

TEST(StreamRun, TheLastOneLostNeverComes) {
  Case c({.fault = Fault::lose, .number = 9, .latency = -1});
  EXPECT_EQ(c.says(),
            "lost: y number 9 never comes, of 10; all that goes in is taken, and nothing moves for "
            "50 clocks");
  // Where nothing moves any more, not where that was seen.
  EXPECT_EQ(c.run().finding->clock, 10U);
}

TEST(StreamRun, WhatOnlyStallsShowNeedsThem) {
  EXPECT_EQ(Case({.fault = Fault::lose_waiting}).says(), "nothing");
  EXPECT_EQ(Case({.fault = Fault::lose_waiting, .stall = 2}).says(),
            "lost: y number 1; number 2 comes instead");
}

TEST(StreamRun, AHangIsFoundWithinTheWatchdog) {
  Case c({.fault = Fault::hang});
  EXPECT_EQ(c.says(), "hung: x number 4 is not taken, and nothing moves for 50 clocks");
  EXPECT_LT(c.run().clocks, 70U);
}

TEST(StreamRun, WhatTheHarnessHoldsBackIsNoHang) {
  EXPECT_EQ(Case({.stall = 200}).says(), "nothing");
}

// Each then takes two clocks; a stall goes on meanwhile.
TEST(StreamRun, OneWhoIsReadyOnlyOnceItSawValidIsServed) {
  for (const Word stall : {0, 1, 7}) {
    Case c({.stall = stall, .waits = 1, .steady = true});
    const StreamResult result = c.run();
    EXPECT_FALSE(result.finding) << stall;
    EXPECT_EQ(result.streams.back().compared, 10U);
    EXPECT_GE(result.clocks,
              10 * (1 + std::max<std::uint64_t>(1, static_cast<std::uint64_t>(stall))) + 17);
  }
}

TEST(StreamRun, ADesignThatWaitsForReadyHangsWithOneThatWaitsForValid) {
  EXPECT_EQ(Case({.fault = Fault::asks, .stall = 3}).says(), "nothing");
  EXPECT_EQ(Case({.fault = Fault::idles, .stall = 3}).says(), "nothing");
  const std::string waits =
      " is not taken, y_ready waits for y_valid, and nothing moves for 50 clocks";
  EXPECT_EQ(Case({.fault = Fault::asks, .waits = 1}).says(), "hung: x number 2" + waits);
  EXPECT_EQ(Case({.fault = Fault::idles, .waits = 1}).says(), "hung: x number 0" + waits);
}

TEST(StreamRun, LateIsMoreThanTheStatedLatency) {
  EXPECT_EQ(Case({.fault = Fault::slow}).says(),
            "late: y number 3 does not come within 1 clock of what it needs");
  EXPECT_EQ(Case({.fault = Fault::slow, .latency = 6}).says(), "nothing");
  EXPECT_EQ(Case({.fault = Fault::slow, .latency = -1}).says(), "nothing");
  // The queue needs one clock, whoever waits.
  EXPECT_EQ(Case({.latency = 0}).says().substr(0, 5), "late:");
  EXPECT_EQ(Case({.stall = 9, .latency = 1}).says(), "nothing");
}

// For it runs the model.
TEST(StreamRun, WhatIsDueIsAskedOnlyWhereSomethingIsWaitedForTooLong) {
  Case at_once({}), late({.fault = Fault::slow});
  at_once.run();
  EXPECT_EQ(at_once.asked(), 0);
  late.run();
  EXPECT_GE(late.asked(), 1);
  EXPECT_LE(late.asked(), 2);
}

TEST(StreamRun, WhatIsOfferedMayNotChangeWhereThatIsStated) {
  EXPECT_EQ(Case({.fault = Fault::change, .stall = 2, .steady = true}).says(),
            "taken back: y number 0 was offered, and is changed before it is taken");
}

// Of x, then of y: one too many came and was compared with nothing.
TEST(StreamRun, EachTransactionIsCounted) {
  const auto counted = [](Case c, std::uint64_t budget = 100000) {
    const auto streams = c.run(budget).streams;
    return std::array{streams[0].moved, streams[0].compared, streams[1].moved, streams[1].compared};
  };
  EXPECT_EQ(counted(Case({})), (std::array<std::uint64_t, 4>{10, 0, 10, 10}));
  EXPECT_EQ(counted(Case({}), 5), (std::array<std::uint64_t, 4>{5, 0, 4, 4}));
  EXPECT_EQ(counted(Case({.fault = Fault::extra_last, .number = 9})),
            (std::array<std::uint64_t, 4>{10, 0, 11, 10}));
  EXPECT_EQ(counted(Case({.fault = Fault::hang, .number = 0})),
            (std::array<std::uint64_t, 4>{1, 0, 1, 1}));
}

TEST(StreamRun, ABudgetEndsItWhereSomethingMoves) {
  EXPECT_EQ(Case({}).run(5).clocks, 5U);
  EXPECT_FALSE(Case({.fault = Fault::value, .number = 9}).run(5).finding);
  // A silence is listened to until it is known what it is.
  EXPECT_TRUE(Case({.fault = Fault::hang}).run(20).finding);
}

// It asks on each second clock, and takes what it is given on that very clock.
class Asker final : public StreamDut {
 public:
  std::vector<Net> nets(const Ports& ports) override {
    const std::map<std::string, Net> named{
        {"ready", net(ready_)},     {"data", {&data_, 1, 0, 8}},     {"asks", net(asks_)},
        {"y_valid", net(y_valid_)}, {"y_data", {&y_data_, 1, 0, 8}}, {"rst", net(rst_)}};
    std::vector<Net> all;
    for (const Field& f : ports.inputs) all.push_back(named.at(f.name));
    for (const Field& f : ports.outputs) all.push_back(named.at(f.name));
    all.push_back(net(clk_));
    return all;
  }
  void eval() override {
    if (clk_ != 0 && before_ == 0) {
      y_valid_ = rst_ == 0 && asks_ != 0 && ready_ != 0 ? 1 : 0;
      y_data_ = data_;
      odd_ = rst_ == 0 && odd_ == 0 ? 1 : 0;
    }
    before_ = clk_;
    asks_ = odd_;
  }

 private:
  static Net net(std::uint8_t& byte) { return {&byte, 1, 0, 1}; }
  std::uint8_t clk_ = 0, before_ = 0, rst_ = 0, odd_ = 0;
  std::uint8_t ready_ = 0, data_ = 0, asks_ = 0, y_valid_ = 0, y_data_ = 0;
};

struct Asked {
  clocked::UInt<8> data;
};
// Gives what is asked for: within the clock, or, where it does not answer, on the next one.
template <bool answers>
struct Answering {
  struct Drives {
    clocked::Bit ready = 0;
    clocked::UInt<8> data = 0x5a;
  };
  struct Reads {
    clocked::Bit asks;
  };
  const Asked* next = nullptr;
  bool was_asked = false, gave = false;

  Drives drive(const Asked* one) {
    next = one;
    gave = !answers && was_asked && next != nullptr;
    return gave ? Drives{1, next->data} : Drives{};
  }
  Drives answer(const Reads& pins) requires answers {
    gave = bool(pins.asks) && next != nullptr;
    return gave ? Drives{1, next->data} : Drives{};
  }
  bool took(const Reads& pins) {
    was_asked = bool(pins.asks);
    return gave;
  }
};

template <bool answers>
StreamResult result_of_asker() {
  StreamShape shape;
  shape.title = "asker";
  shape.set_clocks("clk", "");
  shape.watchdog = 50;
  shape.pins = {clocked::pin::reset("rst")};
  const Field data{"data", 8, Format::number, "", "", 0, "data"};
  shape.add({.name = "x"}, true, {&data, 1}, detail::own_driver<Answering<answers>, Asked, true>());
  shape.add({.name = "y", .has_ready = false}, false, {&data, 1});
  StreamCase given(shape);
  Sequence expected(1);
  for (Word n = 0; n < 10; ++n) {
    given.add(shape, std::array<Word, 3>{1, 0, n});
    expected.push({&n, 1});
  }
  const std::vector<Sequence> all{expected};
  Asker asker;
  return StreamRunner(shape, asker).run({given, all, {}, 1, 10000, false, nullptr});
}

TEST(StreamRun, ADriverMayAnswerWithinTheClock) {
  const StreamResult result = result_of_asker<true>();
  EXPECT_FALSE(result.finding);
  EXPECT_EQ(result.streams.back().compared, 10U);
  EXPECT_TRUE(result_of_asker<false>().finding);
}

}  // namespace
}  // namespace cosim
