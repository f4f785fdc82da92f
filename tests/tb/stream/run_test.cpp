// A queue in C++ in the RTL's place, with every fault that a stream can have: each is found, and
// said by its name.
#include "tb/stream/runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>

namespace cosim {
namespace {

/// What the queue does wrong with the value of number `number`. One that asks says valid only to
/// one who is ready; one that idles takes only while one who takes it on is ready.
// clang-format off
enum class Fault {
  none, value, lose, lose_waiting, twice, swap, extra, extra_last, hang, slow, change, asks, idles
};
// clang-format on

/// Takes 8 bits and gives them one more, at least one clock later. It holds two values.
class Queue final : public StreamDut {
 public:
  Queue(Fault fault, std::uint64_t number) : fault_(fault), number_(number) {}

  std::vector<Net> nets(const Ports& ports) override {
    const std::map<std::string, Net> named{
        {"x_valid", net(x_valid_)}, {"x_ready", net(x_ready_)},  {"x_data", net(x_data_, 8)},
        {"y_valid", net(y_valid_)}, {"y_ready", net(y_ready_)},  {"y_data", net(y_data_, 8)},
        {"z_valid", net(y_valid_)}, {"z_data", net(y_data_, 8)}, {"rst", net(rst_)}};
    std::vector<Net> all;
    for (const Field& f : ports.inputs) all.push_back(named.at(f.name));
    for (const Field& f : ports.outputs) all.push_back(named.at(f.name));
    all.push_back(net(clk_));
    return all;
  }
  void eval() override {
    if (clk_ != 0 && before_ == 0) edge();
    before_ = clk_;
    x_ready_ = held_.size() < 2 && !hung_ && (fault_ != Fault::idles || y_ready_ != 0) ? 1 : 0;
    y_valid_ = !held_.empty() && wait_ == 0 && (fault_ != Fault::asks || y_ready_ != 0) ? 1 : 0;
    y_data_ = held_.empty() ? 0 : held_.front();
  }

 private:
  static Net net(std::uint8_t& byte, int width = 1) { return {&byte, 1, 0, width}; }

  void edge() {
    if (rst_ != 0) {
      held_.clear();
      taken_ = 0;
      hung_ = false;
      wait_ = 0;
      return;
    }
    if (y_valid_ != 0 && y_ready_ != 0) held_.pop_front();
    if (y_valid_ != 0 && y_ready_ == 0 && fault_ == Fault::change) held_.front() ^= 0x80;
    if (wait_ != 0) --wait_;
    if (x_valid_ != 0 && x_ready_ != 0) take(static_cast<std::uint8_t>(x_data_ + 1));
  }
  void take(std::uint8_t value) {
    const bool here = taken_++ == number_;
    const bool waits = y_valid_ != 0 && y_ready_ == 0;
    if (here && fault_ == Fault::hang) hung_ = true;
    if (here && fault_ == Fault::slow) wait_ = 5;
    if (here && fault_ == Fault::value) value ^= 4;
    if (here && fault_ == Fault::lose) return;
    if (waits && fault_ == Fault::lose_waiting) return;
    if (here && fault_ == Fault::extra) held_.push_back(0xee);
    held_.push_back(value);
    if (here && fault_ == Fault::twice) held_.push_back(value);
    if (here && fault_ == Fault::extra_last) held_.push_back(0xee);
    if (here && fault_ == Fault::swap) kept_ = value;
    if (here && fault_ == Fault::swap) held_.pop_back();
    if (taken_ == number_ + 2 && fault_ == Fault::swap) held_.push_back(kept_);
  }

  Fault fault_;
  std::uint64_t number_;
  std::uint8_t clk_ = 0, before_ = 0, rst_ = 0;
  std::uint8_t x_valid_ = 0, x_ready_ = 0, x_data_ = 0, y_valid_ = 0, y_ready_ = 0, y_data_ = 0;
  std::deque<std::uint8_t> held_;
  std::uint8_t kept_ = 0;
  std::uint64_t taken_ = 0;
  int wait_ = 0;
  bool hung_ = false;
};

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
    shape_.pins = {pin::reset("rst")};
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
    EXPECT_EQ(result.transactions, 10U);
    // One clock each and its stall, one before the first, and some behind the last.
    EXPECT_GE(result.clocks, 10 * (1 + static_cast<std::uint64_t>(stall)) + 17);
  }
}

TEST(StreamRun, EachOfTwoStreamsIsTaken) {
  const StreamResult result = Case({.twofold = true}).run();
  EXPECT_FALSE(result.finding);
  EXPECT_EQ(result.transactions, 20U);
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
    EXPECT_EQ(result.transactions, 10U);
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

TEST(StreamRun, ABudgetEndsItWhereSomethingMoves) {
  EXPECT_EQ(Case({}).run(5).clocks, 5U);
  EXPECT_FALSE(Case({.fault = Fault::value, .number = 9}).run(5).finding);
  // A silence is listened to until it is known what it is.
  EXPECT_TRUE(Case({.fault = Fault::hang}).run(20).finding);
}

}  // namespace
}  // namespace cosim
