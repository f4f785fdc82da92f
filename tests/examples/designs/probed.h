// Golden model of probed.v.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Probed {
  struct In {
    Bit rst;  // begin anew at 0
    Bit en;   // count this clock
  };
  struct Out {
    UInt<4> q;  // the count
  };
  static constexpr auto reset = active_high<&In::rst>;
  static constexpr std::array unobserved{"debug.*", "spare"};

  UInt<4> count = 0;  // the count: the register is counter.value, and `count` of the top carries it

  Out clock(const In& in) {
    const Out out{.q = count};
    if (in.rst) {
      count = 0;
    } else {
      count += in.en;
    }
    return out;
  }
};
