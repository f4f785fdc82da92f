// Golden model of examples/uart/uart.v.
#pragma once

#include "model/clocked/model.h"

namespace cosim::clocked::test {

/// D: clocks a bit, 1 to 256.
template <int D>
struct Uart {
  struct In {
    Bit rst_n, valid;
    UInt<8> data;
  };
  struct Out {
    Bit ready, tx;
  };

  UInt<4> left = 0;                        // bits of the frame still to come
  Unreset<UInt<9>> frame;                  // what is left of it, the next bit lowest
  At<"divider.count", UInt<8>> count = 0;  // clocks of this bit

  Out clock(const In& in) {
    const Out out{.ready = left == 0, .tx = left == 0 || frame[0]};
    const Bit tick = count == D - 1;
    if (!in.rst_n) {
      left = 0;
      count = 0;
    } else if (left == 0 && in.valid) {
      left = 10;
      frame = in.data << 1;
      count = 0;
    } else if (!tick) {
      ++count;
    } else {
      count = 0;
      if (left != 0) {
        --left;
        frame = frame >> 1 | 0x100;
      }
    }
    return out;
  }
};

}  // namespace cosim::clocked::test
