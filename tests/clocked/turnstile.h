// A model whose ways are told apart by hand (way_points_test.cpp).
#pragma once

#include <string>

#include "model/clocked/model.h"

namespace cosim::clocked::test {

struct Turnstile {
  struct In {
    Bit rst;
    Bit pays;
    UInt<4> coins;
  };
  struct Out {
    Bit is_open;
  };
  UInt<6> paid = 0;

  Out clock(const In& in) {
    const Out out{.is_open = paid >= 20};
    if (in.rst) {
      paid = 0;
    } else if (in.pays) {
      const UInt<7> sum = paid + in.coins;
      paid = sum > 40 ? UInt<7>(40) : sum;
    } else {
      for (int i = 0; i < 2; ++i) {
        if (paid >= 20) paid -= 20;
      }
    }
    return out;
  }

  /// The way that a clock with these inputs takes: what its last condition is, and those before it.
  std::string way(const In& in) const {
    const unsigned coins = unsigned(in.coins.value()), had = unsigned(paid.value());
    if (in.rst.value() == 1) return "true: if (in.rst)";
    if (in.pays.value() == 1) {
      const std::string last = "paid = sum > 40 ? UInt<7>(40) : sum; after RST false, PAYS true";
      return (had + coins > 40 ? "true: " : "false: ") + last;
    }
    const std::string last = "if (paid >= 20) paid -= 20; after RST false, PAYS false";
    if (had >= 40) return "true: " + last + ", PAID true";
    return had >= 20 ? "false: " + last + ", PAID true" : "false: " + last;
  }
};

}  // namespace cosim::clocked::test
