// Golden model of decade.sv. It has no invariant.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Decade {
  struct In {
    Bit rst;  // begin anew
    Bit en;   // count this clock
  };
  struct Out {
    UInt<4> digit;
    Bit carry;  // ten clocks were counted
  };
  static constexpr auto reset = active_high<&In::rst>;

  UInt<4> digit_q = 0;  // 0 to 9

  Out clock(const In& in) {
    const Out out{.digit = digit_q, .carry = in.en && digit_q == 9};
    if (in.rst || out.carry) {
      digit_q = 0;
    } else if (in.en) {
      if (digit_q > 9) {
        digit_q = 0;
      } else {
        ++digit_q;
      }
    }
    return out;
  }
};
