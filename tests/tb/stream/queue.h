// A queue in C++ in the RTL's place, with every fault that a stream can have.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "tb/stream/dut.h"

namespace cosim::test {

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

}  // namespace cosim::test
