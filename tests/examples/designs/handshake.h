// Golden model of handshake.v.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Handshake {
  struct In {
    Bit rst;       // begin anew
    Bit valid;     // there is a number
    UInt<8> data;  // the number
    UInt<3> by;    // what it is divided by
  };
  struct Out {
    Bit ready;     // the number is taken
    UInt<32> sum;  // of all so far
  };
  static constexpr auto reset = active_high<&In::rst>;
  static constexpr In rest() { return {.rst = 0, .valid = 0, .data = 0, .by = 1}; }

  Bit busy = 0;        // a number was seen
  UInt<8> asked = 0;   // the last that was
  UInt<32> total = 0;  // of all so far

  Out clock(const In& in) {
    const Out out{.ready = busy, .sum = total};
    if (in.rst) {
      *this = Handshake{};
    } else if (busy) {
      busy = 0;
      total += asked / in.by;
    } else if (in.valid) {
      busy = 1;
      asked = in.data;
    }
    return out;
  }

  auto legal(const In& in) const {
    return stated({{"a number is held until ready", !busy || (in.valid && in.data == asked)},
                   {"by is not 0", in.by != 0}});
  }
  In idle() const { return {.rst = 0, .valid = busy, .data = mux(busy, asked, 0), .by = 1}; }
};
