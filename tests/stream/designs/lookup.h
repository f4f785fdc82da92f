// A table that has the squares of 0 to 9: for another key hit is 0, and data means nothing.
#pragma once

#include <cosim/stream.h>

template <int FAULT>
struct Lookup {
  struct X {
    UInt<4> key;
  };
  struct Y {
    Bit hit;
    UInt<8> data;
  };
  static constexpr auto in() { return stream<X>("x"); }
  static constexpr auto out() { return stream<Y>("y"); }
  static constexpr auto pins() { return std::array{pin::reset("rst")}; }
  static auto compared(const Y& y) { return stated({{"data", y.hit}}); }

  static std::vector<Y> run(const std::vector<X>& x) {
    std::vector<Y> y;
    for (const X& one : x) {
      const Bit hit = one.key < 10;
      y.push_back({hit, mux(hit, one.key * one.key, 0)});
    }
    return y;
  }
};
