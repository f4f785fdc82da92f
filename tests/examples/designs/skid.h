// Golden model of skid.v. Its state has more than the registers: how many bytes were taken. What no
// reset reaches is taken over by name all the same.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Skid {
  struct In {
    Bit rst;               // begin anew
    Bit in_valid;          // a byte is offered
    Hex<UInt<8>> in_data;  // that byte
    Bit out_ready;         // the byte is taken
  };
  struct Out {
    Bit in_ready;           // what is offered is taken
    Bit out_valid;          // a byte is there
    Hex<UInt<8>> out_data;  // the last one
  };
  static constexpr auto reset = active_high<&In::rst>;

  Auxiliary<UInt<8>> taken = 0;    // bytes that were taken
  Bit out_valid = 0;               // a byte is there
  Unreset<Hex<UInt<8>>> out_data;  // the last one

  Out clock(const In& in) {
    const Out out{
        .in_ready = !out_valid || in.out_ready, .out_valid = out_valid, .out_data = out_data};
    if (out.in_ready) {
      out_valid = in.in_valid;
      taken += in.in_valid;
      if (in.in_valid) out_data = in.in_data;
    }
    if (in.rst) {
      taken = 0;
      out_valid = 0;
    }
    return out;
  }
};
