// Credits on both sides.
#pragma once

#include <cosim/stream.h>

template <int FAULT>
struct Credits {
  struct Passed {
    Hex<UInt<16>> word;  // what passes
  };
  static constexpr auto in() { return stream<Passed>("in").credit(4); }
  static constexpr auto out() { return stream<Passed>("out").credit(2); }
  static constexpr auto pins() { return std::array{pin::reset("rst")}; }
  static auto run(const std::vector<Passed>& in) { return in; }
};
