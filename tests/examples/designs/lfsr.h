// Golden model of lfsr.v.
#pragma once

#include <cosim/model.h>

/// MODE: HOLD or FILL, what it does while it is not enabled.
template <int FAULT, int TAPS, Text MODE>
struct Lfsr {
  struct In {
    Bit en;  // shift this clock
  };
  struct Out {
    Hex<UInt<8>> q;  // the register
  };

  Hex<UInt<8>> bits = 0xa5;  // the register; nothing clears it

  Out clock(const In& in) {
    const Out out{.q = bits};
    if (in.en) {
      bits = bits >> 1 ^ mux(bits[0], TAPS, 0);
    } else if (std::string_view(MODE) == "FILL") {
      bits = bits << 1 | 1;
    }
    return out;
  }
};
