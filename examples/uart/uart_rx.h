// Golden model of uart_rx.v.
#pragma once

#include <cosim/model.h>

/// D: clocks a bit, 4 to 256.
template <int D>
struct UartRx {
  struct In {
    Bit rst_n;  // 0: stop at once
    Bit rx;     // the line
  };
  struct Out {
    Bit valid;          // a byte has come
    Bit error;          // one has, but its stop bit is 0
    Hex<UInt<8>> data;  // the byte
  };
  static constexpr auto reset = active_low<&In::rst_n>;
  static constexpr In rest() { return {.rst_n = 1, .rx = 1}; }

  Unreset<Hex<UInt<2>>> sync;   // the line on the last two clocks
  UInt<4> left = 0;             // bits of the frame still to come
  Unreset<UInt<8>> count;       // clocks to the middle of the next
  Unreset<Hex<UInt<9>>> frame;  // the last bits, the newest highest
  Bit done = 0;                 // the frame is whole

  Out clock(const In& in) {
    const Bit line = sync[1], good = frame[8];
    const Out out{.valid = done && good, .error = done && !good, .data = frame.slice<7, 0>()};
    const Bit start = left == 0 && !line;
    const Bit sample = left != 0 && count == 0;
    done = in.rst_n && sample && left == 1;
    if (start) {
      left = 10;
      count = D / 2 - 1;
    } else if (sample) {
      const Bit glitch = left == 10 && line;  // no start bit after all
      left = mux(glitch, 0, left - 1);
      count = D - 1;
      frame = cat(line, frame.slice<8, 1>());
    } else {
      --count;
    }
    if (!in.rst_n) left = 0;
    sync = cat(sync[0], in.rx);
    return out;
  }
};
