// Golden model of synced.v.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Synced {
  struct In {
    Bit reset;  // on the third clock from here
    Bit en;     // count this clock
  };
  struct Out {
    UInt<3> q;  // the count
  };
  static constexpr auto reset = active_high<&In::reset>;
  static constexpr int reset_clocks = 3;

  Bit first = 1;      // reset, one clock ago
  Bit second = 1;     // reset, two clocks ago
  UInt<3> count = 0;  // the count

  Out clock(const In& in) {
    const Out out{.q = count};
    if (second) {
      count = 0;
    } else {
      count += in.en;
    }
    second = first;
    first = in.reset;
    return out;
  }
};
