// Golden model of counted.sv, with its fault too: what is wrong with that only shows where the
// first register of the synchronizer takes the old value in some bits and the new one in others.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Counted {
  using Code = Hex<UInt<4>>;
  struct In {
    Bit rst_n;                         // 0 begins anew, at once
    Rises a_clk;                       // the side that counts
    Bit tick;                          // there is an event
    Rises b_clk;                       // the side that looks on
    Sampled<"first", Code> first_new;  // bits of first that take the new value
  };
  struct Out {
    UInt<4> seen;  // events seen
  };
  static constexpr auto reset = active_low<&In::rst_n>;
  static constexpr bool asynchronous_reset = true;

  UInt<4> count = 0;  // events, at most 15
  Code code = 0;      // the same in the code that crosses
  Code first = 0;     // the code, at the other clock
  Code second = 0;    // the same, a clock of that later

  Out clock(const In& in) {
    Out out{.seen = second};
    if (FAULT == 0) out.seen = second ^ second >> 1 ^ second >> 2 ^ second >> 3;
    const Code before = code;
    if (in.a_clk) {
      count += in.tick && count < 15;
      code = count;
      if (FAULT == 0) code = count ^ count >> 1;
    }
    if (in.b_clk) {
      second = first;
      first = before;
    }
    return out;
  }
};
