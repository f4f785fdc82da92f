// Golden model of released.v.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Released {
  struct In {
    Bit rst_n;  // 0: reset, at once
    Bit stop;   // reset, at the clock
    Bit en;     // count this clock
  };
  struct Out {
    UInt<3> q;  // the count
  };
  static constexpr auto reset = active_low<&In::rst_n>;

  Bit first = 0;      // no reset so far
  Bit ready = 0;      // it may count
  UInt<3> count = 5;  // the count

  Out clock(const In& in) {
    const Out out{.q = count};
    if (!ready) {
      count = 5;  // on the edge on which it ends the reset still holds
    } else {
      count += in.en;
    }
    ready = first && !in.stop;
    first = 1;
    return out;
  }

  void reset_at_once(const In& in) {
    if (!in.rst_n) {
      first = 0;
      ready = 0;
    }
    if (!ready) count = 5;
  }
};
