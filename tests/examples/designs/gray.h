// Golden model of gray.v.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Gray {
  struct In {
    Bit rst_n;  // 0: begin anew, at once
    Bit en;     // count this clock
  };
  struct Out {
    Hex<UInt<4>> code;  // the count in Gray code
    Bit odd;            // the clocks counted are odd
    UInt<4> clocks;     // all of them
  };
  static constexpr auto reset = active_low<&In::rst_n>;
  static constexpr bool asynchronous_reset = true;

  UInt<4> count = 3;     // the clocks counted, and 3
  Bit odd = 0;           // they are odd
  Unreset<UInt<4>> all;  // resets do not matter

  // The reset does not appear here: under it the state is cleared before the clock.
  Out clock(const In& in) {
    const Out out{.code = count ^ count >> 1, .odd = odd, .clocks = all};
    if (in.en) {
      ++count;
      odd = !odd;
      ++all;
    }
    return out;
  }
};
