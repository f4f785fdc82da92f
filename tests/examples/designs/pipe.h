// Golden model of pipe.v.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Pipe {
  struct In {
    Bit rst;       // forget all numbers
    Bit valid;     // there is a number
    UInt<6> data;  // the number
  };
  struct Out {
    Bit done;        // there is a square
    UInt<8> result;  // the square, modulo 256
  };
  static constexpr auto reset = active_high<&In::rst>;

  Bit busy = 0;        // there is a number
  Bit last = 0;        // there is a square
  UInt<6> number = 0;  // the number
  UInt<8> square = 0;  // the square, modulo 256

  Out clock(const In& in) {
    const Out out{.done = last, .result = square};
    square = number * number;
    number = mux(in.valid, in.data, 0);  // where there is none the RTL has any other value
    last = busy && !in.rst;
    busy = in.valid && !in.rst;
    return out;
  }

  auto compared() const { return stated({{"number", busy}, {"square", last}}); }
  auto compared(const In&, const Out& out) const { return stated({{"result", out.done}}); }
};
