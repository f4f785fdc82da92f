// Both models of guarded.sv: what it does on every clock, and that what passes is as it was.
#pragma once

#include <cosim/stream.h>

template <int FAULT>
struct Guarded {
  struct In {
    Bit rst;         // nothing is held
    Bit x_valid;     // a number is offered
    UInt<8> x_data;  // it
    Bit y_ready;     // what is held is taken
  };
  struct Out {
    Bit x_ready;     // a number is taken
    Bit y_valid;     // a number is held
    UInt<8> y_data;  // it
  };
  static constexpr auto reset = active_high<&In::rst>;

  Bit y_valid = 0;          // a number is held
  Unreset<UInt<8>> y_data;  // it
  Unreset<Bit> odd;         // its parity

  static Bit is_odd(const UInt<8>& data) {
    Bit parity = reduce_xor(data);
    if (FAULT != 0) parity ^= data > 100;
    return parity;
  }

  Out clock(const In& in) {
    const Out out{.x_ready = !y_valid || in.y_ready, .y_valid = y_valid, .y_data = y_data};
    if (out.x_ready) {
      y_valid = in.x_valid;
      y_data = in.x_data;
      odd = is_odd(in.x_data);
    }
    if (in.rst) y_valid = 0;
    return out;
  }

  auto invariant() const {
    return stated({{"the parity is that of what is held", !y_valid || odd == is_odd(y_data)}});
  }

  struct Passed {
    UInt<8> data;  // what passes
  };
  static constexpr auto in() { return stream<Passed>("x"); }
  static constexpr auto out() { return stream<Passed>("y").latency(1).steady(); }
  static constexpr auto pins() { return std::array{pin::reset("rst")}; }
  static auto run(const std::vector<Passed>& x) { return x; }
};
