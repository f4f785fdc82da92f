// Golden model of window.sv.
#pragma once

#include <cosim/model.h>

template <int N>
struct Window {
  struct In {
    Bit rst_n;
    UInt<8> in;
  };
  struct Out {
    UInt<8> out;
    UInt<4> n;
  };
  static constexpr auto reset = active_low<&In::rst_n>;
  static constexpr bool asynchronous_reset = true;

  Array<UInt<8>, 2> held = 0;
  UInt<4> n = 0;
  UInt<2> state = 0;

  Out clock(const In& in) {
    const Out out{.out = held[1], .n = n};
    const bool valid = in.in[7];
    if (!in.rst_n) {
      *this = Window{};
      return out;
    }
    if (valid) {
      held[1] = held[0];
      held[0] = in.in;
    }
    if (state == 0) {
      if (valid) state = 1;
    } else if (state == 1) {
      if (n == 3) state = 2;
      ++n;
    } else {
      state = 0;
    }
    return out;
  }
};
