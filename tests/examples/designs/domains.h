// Golden model of domains.v.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Domains {
  struct In {
    Rises a_clk;  // the side that sends
    Bit a_rst;    // resets it, at its clock
    Bit send;     // there is an event
    Falls b_clk;  // the side that counts
    Bit b_rst_n;  // resets it where it is 0, at once
  };
  struct Out {
    UInt<3> q;  // events seen
  };
  static constexpr auto reset = both(active_high<&In::a_rst>, active_low<&In::b_rst_n>);

  Bit turned = 0;    // over, on each event
  Bit first = 0;     // the same, sampled
  Bit second = 0;    // a clock later
  Bit last = 0;      // two clocks later
  UInt<3> seen = 0;  // events seen

  Out clock(const In& in) {
    const Out out{.q = seen};
    const Bit before = turned;
    if (in.a_clk) {
      if (in.a_rst) {
        turned = 0;
      } else if (in.send) {
        turned = !turned;
      }
    }
    if (in.b_clk) {
      seen += second != last;
      last = second;
      second = first;
      first = before;
    }
    return out;
  }

  void reset_at_once(const In& in) {
    if (!in.b_rst_n) {
      first = 0;
      second = 0;
      last = 0;
      seen = 0;
    }
  }
};
