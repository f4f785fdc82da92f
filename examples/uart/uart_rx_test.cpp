// The receiver by hand: a driver that sends on the line, and what is to come of it.
#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "tb/sim/directed.h"
#include "uart_rx.h"

namespace {

using cosim::Directed;

// Drives the line: bits of D clocks each, and 1 behind the last.
template <int D>
class Line {
  using In = typename UartRx<D>::In;
  using Out = typename UartRx<D>::Out;

 public:
  explicit Line(Directed<UartRx<D>>& bench) {
    bench.add([this](In& in, const Out&) {
      in.rx = left_.empty() ? 1 : left_.front();
      if (!left_.empty()) left_.pop_front();
    });
  }
  void level(int value, int clocks) { left_.insert(left_.end(), clocks, value); }
  void send(int byte, int stop = 1) {
    level(0, D);
    for (int i = 0; i < 8; ++i) level(byte >> i & 1, D);
    level(stop, D);
  }

 private:
  std::deque<int> left_;
};

template <class Rate>
class Receiver : public testing::Test {
 protected:
  static constexpr int D = Rate::value;
  using Model = UartRx<D>;

  Receiver() {
    bench.clocks(D);  // the line rests until the synchroniser, which had anything, has it
    bench.watch([this](const typename Model::In&, const typename Model::Out& out) {
      if (out.valid) bytes.push_back(int(out.data));
      errors += out.error ? 1 : 0;
    });
  }
  Directed<Model> bench;
  Line<D> line{bench};
  std::vector<int> bytes;
  int errors = 0;
};
using Rates = testing::Types<std::integral_constant<int, 4>, std::integral_constant<int, 16>>;
TYPED_TEST_SUITE(Receiver, Rates);

TYPED_TEST(Receiver, TakesEveryByteOneAfterTheOther) {
  std::vector<int> sent;
  for (int byte = 0; byte < 256; ++byte) {
    this->line.send(byte);
    sent.push_back(byte);
  }
  this->bench.clocks(256 * 10 * TypeParam::value + 4);
  EXPECT_EQ(this->bytes, sent);
  EXPECT_EQ(this->errors, 0);
}

TYPED_TEST(Receiver, AWrongStopBitIsAnError) {
  this->line.send(0x55, 0);
  this->line.level(1, TypeParam::value);
  this->line.send(0x33);
  this->bench.clocks(21 * TypeParam::value + 4);
  EXPECT_EQ(this->bytes, std::vector<int>{0x33});
  EXPECT_EQ(this->errors, 1);
}

TYPED_TEST(Receiver, AGlitchIsNoStartBit) {
  this->line.level(0, 1);
  this->line.level(1, TypeParam::value);
  this->line.send(0x0f);
  this->bench.clocks(11 * TypeParam::value + 5);
  EXPECT_EQ(this->bytes, std::vector<int>{0x0f});
}

TYPED_TEST(Receiver, AResetEndsTheFrame) {
  this->line.send(0);
  this->bench.clocks(5 * TypeParam::value);
  this->bench.in.rst_n = 0;
  this->bench.clocks(6 * TypeParam::value);
  this->bench.in.rst_n = 1;
  this->line.send(0x7e);
  EXPECT_TRUE(
      this->bench.until([](const auto& out) { return bool(out.valid); }, 11 * TypeParam::value));
  EXPECT_EQ(this->bytes, std::vector<int>{0x7e});
}

}  // namespace
