// Golden model of laps.v.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Laps {
  struct In {
    Bit rst_n;  // 0: all anew, at once
    Bit lap;    // 1: a new lap, at once
    Bit en;     // count this clock
  };
  struct Out {
    UInt<6> clocks;   // counted
    UInt<4> since;    // of them in this lap, and 1
    UInt<4> longest;  // the most there was
  };
  static constexpr auto reset = both(active_low<&In::rst_n>, active_high<&In::lap>);

  UInt<6> count = 0;
  UInt<4> part = 1;
  UInt<4> most = 0;

  Out clock(const In& in) {
    const Out out{.clocks = count, .since = part, .longest = most};
    if (!in.rst_n) {
      most = 0;
    } else if (part > most) {
      most = part;
    }
    count += in.en;
    part += in.en;
    return out;
  }

  /// Under the resets that do not wait for the clock.
  void reset_at_once(const In& in) {
    if (!in.rst_n) count = 0;
    if (in.lap) part = 1;
  }
};
