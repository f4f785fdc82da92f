// The receiver by hand: a driver that sends on the line, and what is to come of it.
#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <vector>

#include "tb/gtest/directed.h"
#include "uart_rx.h"

namespace uart_rx_model {

using namespace cosim;

namespace {

// Drives the line: bits of so many clocks each, and 1 behind the last.
class Line {
 public:
  Line(Directed<Design>& bench, int clocks) : clocks_(clocks) {
    bench.add([this](Inputs<Word>& in, const Outputs<Word>&) {
      in.rx = left_.empty() ? 1 : left_.front();
      if (!left_.empty()) left_.pop_front();
    });
  }
  void level(int value, int clocks) { left_.insert(left_.end(), clocks, value); }
  void send(int byte, int stop = 1) {
    level(0, clocks_);
    for (int i = 0; i < 8; ++i) level(byte >> i & 1, clocks_);
    level(stop, clocks_);
  }

 private:
  int clocks_;
  std::deque<int> left_;
};

class Receiver : public testing::TestWithParam<int> {
 protected:
  Receiver() {
    bench.clocks(GetParam());  // the line rests until the synchroniser, which had anything, has it
    bench.watch([this](const Inputs<Word>&, const Outputs<Word>& out) {
      if (out.valid != 0) bytes.push_back(out.data);
      errors += out.error;
    });
  }
  Directed<Design> bench{"D=" + std::to_string(GetParam())};
  Line line{bench, GetParam()};
  std::vector<Word> bytes;
  Word errors = 0;
};

TEST_P(Receiver, TakesEveryByteOneAfterTheOther) {
  std::vector<Word> sent;
  for (int byte = 0; byte < 256; ++byte) {
    line.send(byte);
    sent.push_back(byte);
  }
  bench.clocks(256 * 10 * GetParam() + 4);
  EXPECT_EQ(bytes, sent);
  EXPECT_EQ(errors, 0);
}

TEST_P(Receiver, AWrongStopBitIsAnError) {
  line.send(0x55, 0);
  line.level(1, GetParam());
  line.send(0x33);
  bench.clocks(21 * GetParam() + 4);
  EXPECT_EQ(bytes, std::vector<Word>{0x33});
  EXPECT_EQ(errors, 1);
}

TEST_P(Receiver, AGlitchIsNoStartBit) {
  line.level(0, 1);
  line.level(1, GetParam());
  line.send(0x0f);
  bench.clocks(11 * GetParam() + 5);
  EXPECT_EQ(bytes, std::vector<Word>{0x0f});
}

TEST_P(Receiver, AResetEndsTheFrame) {
  line.send(0);
  bench.clocks(5 * GetParam());
  bench.in.rst_n = 0;
  bench.clocks(6 * GetParam());
  bench.in.rst_n = 1;
  line.send(0x7e);
  EXPECT_TRUE(bench.until([](const auto& out) { return out.valid != 0; }, 11 * GetParam()));
  EXPECT_EQ(bytes, std::vector<Word>{0x7e});
}

INSTANTIATE_TEST_SUITE_P(Rates, Receiver, testing::Values(4, 16));

}  // namespace
}  // namespace uart_rx_model
