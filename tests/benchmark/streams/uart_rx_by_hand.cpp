// The receiver in a GoogleTest by hand, as one writes it without a harness: any value on its
// inputs, and its outputs compared with a class that does what it does.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "Vuart_rxD16.h"

namespace {

class Receiver {
 public:
  bool valid = false, error = false;
  int data = 0;

  void clock(bool rst_n, bool rx) {
    const bool line = (sync_ & 2) != 0;
    const bool start = left_ == 0 && !line, sample = left_ != 0 && count_ == 0;
    const bool done = rst_n && sample && left_ == 1;
    sync_ = ((sync_ << 1) | (rx ? 1 : 0)) & 3;
    count_ = start ? 7 : sample ? 15 : (count_ - 1) & 255;
    if (sample) frame_ = (frame_ >> 1) | (line ? 256 : 0);
    if (!rst_n) {
      left_ = 0;
    } else if (start) {
      left_ = 10;
    } else if (sample) {
      left_ = left_ == 10 && line ? 0 : left_ - 1;
    }
    valid = done && (frame_ & 256) != 0;
    error = done && (frame_ & 256) == 0;
    data = frame_ & 255;
  }

 private:
  int sync_ = 0, left_ = 0, count_ = 0, frame_ = 0;
};

TEST(UartRx, DoesWhatTheClassDoes) {
  const long clocks = std::atol(std::getenv("CLOCKS"));
  VerilatedContext context;
  Vuart_rxD16 top(&context);
  Receiver expected;
  std::mt19937_64 random(1);
  std::uint64_t bits = 0;
  for (long i = 0; i < clocks; ++i, bits >>= 2) {
    if (i % 32 == 0) bits = random();
    // A reset is rare at first, for a frame has to pass that fills all registers.
    top.rst_n = i < 8 ? 0 : i < 4096 ? 1 : bits & 1;
    top.rx = i < 4096 ? i / 16 % 11 != 0 : bits >> 1 & 1;
    top.clock = 0;
    top.eval();
    if (i > 4096) {
      ASSERT_EQ(top.valid, expected.valid) << "clock " << i;
      ASSERT_EQ(top.error, expected.error) << "clock " << i;
      ASSERT_EQ(top.data, expected.data) << "clock " << i;
    }
    expected.clock(top.rst_n != 0, top.rx != 0);
    top.clock = 1;
    top.eval();
  }
}

}  // namespace
