// Golden model of timer.vhd.
#pragma once

#include <cosim/model.h>

/// WIDTH: bits of the clocks to count.
template <int WIDTH>
struct Timer {
  struct In {
    Bit rst;           // give up
    Bit start;         // begin, where it idles
    UInt<WIDTH> load;  // clocks to count
  };
  struct Out {
    Bit busy;  // it does not idle
    Bit done;  // the time is over
  };
  static constexpr auto reset = active_high<&In::rst>;
  enum { idling, running, ending };

  UInt<2> state = idling;
  UInt<WIDTH> count = 0;  // clocks that are left
  Bit done_q = 0;         // the time is over

  Out clock(const In& in) {
    const Out out{.busy = state != idling, .done = done_q};
    done_q = state == ending;
    if (state == idling) {
      if (in.start) {
        count = in.load;
        state = running;
      }
    } else if (state == running) {
      if (count == 0) {
        state = ending;
      } else {
        --count;
      }
    } else {
      state = idling;
    }
    if (in.rst) *this = Timer{};
    return out;
  }
};
