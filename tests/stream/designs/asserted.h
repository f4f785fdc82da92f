// Golden model of asserted.sv, with its fault.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Asserted {
  struct In {
    Bit rst;  // begin anew at 0
    Bit en;   // count this clock
  };
  struct Out {
    UInt<4> count;  // the clocks so far
  };
  static constexpr auto reset = active_high<&In::rst>;

  UInt<4> count = 0;  // the clocks so far

  Out clock(const In& in) {
    const Out out{.count = count};
    if (in.rst) {
      count = 0;
    } else if (in.en) {
      count = mux(count == 9 + FAULT, 0, count + 1);
    }
    return out;
  }
};
