// Golden model of counter.v.
#pragma once

#include <cosim/model.h>

/// W: bits of the count.
template <int W>
struct Counter {
  struct In {
    Bit rst;  // begin anew at 0
    Bit en;   // count this clock
  };
  struct Out {
    UInt<W> count;  // the clocks so far
    Bit last;       // the count is all ones
  };
  static constexpr auto reset = active_high<&In::rst>;

  UInt<W> total = 0;  // the clocks so far

  Out clock(const In& in) {
    const Out out{.count = total, .last = reduce_and(total)};
    if (in.rst) {
      total = 0;
    } else {
      total += in.en;
    }
    return out;
  }
};
