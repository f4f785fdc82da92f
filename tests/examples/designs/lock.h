// Golden model of lock.sv.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Lock {
  struct In {
    Bit rst;             // begin anew
    Hex<UInt<16>> code;  // a word
  };
  struct Out {
    Bit bell;  // it is open, and one rings
    UInt<4> clocks;
  };
  static constexpr auto reset = active_high<&In::rst>;

  Bit half_q = 0;  // the first word was last
  Bit last_q = 0;  // the second one was
  Bit open_q = 0;  // both were
  UInt<4> clocks_q = 0;

  Out clock(const In& in) {
    const Bit both_q = half_q && last_q;
    const Out out{.bell = (open_q && in.code[0]) || both_q, .clocks = clocks_q};
    if (in.rst) {
      *this = Lock{};
    } else {
      open_q = open_q || (half_q && in.code == 0xbeef);
      half_q = in.code == 0xc0de;
      last_q = in.code == 0xbeef;
      ++clocks_q;
    }
    return out;
  }
};
