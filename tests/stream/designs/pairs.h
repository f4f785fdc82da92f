// Two streams in and two out, wide fields, pins that belong to no stream.
#pragma once

#include <cosim/stream.h>

template <int FAULT>
struct Pairs {
  struct A {
    UInt<8> number;        // a
    At<"mode", Bit> swap;  // in the other order
  };
  struct B {
    UInt<8> number;  // b
  };
  struct Sum {
    UInt<9> total;  // a + b
  };
  struct Parts {
    Hex<UInt<100>> both;  // one at each end
  };
  static constexpr auto in() {
    return std::tuple{stream<A>("a"), stream<B>("b").valid("b_vld").ready("b_rdy")};
  }
  static constexpr auto out() {
    return std::tuple{stream<Sum>("sum").latency(1).steady(), stream<Parts>("parts").steady()};
  }
  static constexpr auto pins() {
    return std::array{pin::reset_low("rst_n"), pin::tied("test_mode", 9, 4), pin::unread("busy")};
  }
  static auto run(const std::vector<A>& a, const std::vector<B>& b) {
    std::vector<Sum> sums;
    std::vector<Parts> parts;
    for (std::size_t n = 0; n < a.size() && n < b.size(); ++n) {
      sums.push_back({a[n].number + b[n].number});
      const auto high = a[n].swap ? b[n].number : a[n].number;
      const auto low = a[n].swap ? a[n].number : b[n].number;
      parts.push_back({cat(high, UInt<84>(0), low)});
    }
    return std::tuple{sums, parts};
  }
};
