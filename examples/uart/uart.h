// Golden model of uart.v.
#pragma once

#include <cosim/model.h>

/// D: clocks a bit, 1 to 256.
template <int D>
struct Uart {
  struct In {
    Bit rst_n;          // 0: stop at once
    Bit valid;          // there is a byte to send
    Hex<UInt<8>> data;  // the byte
  };
  struct Out {
    Bit ready;  // a byte would be taken
    Bit tx;     // the line
  };
  static constexpr auto reset = active_low<&In::rst_n>;

  UInt<4> left = 0;                        // bits of the frame still to come
  Unreset<Hex<UInt<9>>> frame;             // what is left of it, the next bit lowest
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

  /// What must be possible on a clock.
  auto cases(const In& in) const {
    return stated({{"a byte is taken", left == 0 && in.valid},
                   {"a stop bit ends", left == 1 && count == D - 1},
                   {"a byte is stopped by a reset", left != 0 && !in.rst_n}});
  }

  struct Job {
    Range<0, 40> idle;   // clocks before the byte
    Range<0, 255> byte;  // what is sent after them
  };
  /// Waits, offers the byte until it is taken, and waits until it is out.
  struct Driver {
    UInt<6> idled = 0;  // clocks waited
    Bit taken = 0;      // the byte was taken

    In drive(const Job& job, In in) const {
      in.valid = idled >= job.idle && !taken;
      in.data = job.byte;
      return in;
    }
    Bit driven(const Job& job, const Out& out) {
      const Bit over = taken && out.ready;
      if (idled < job.idle) {
        ++idled;
      } else if (out.ready) {
        taken = 1;
      }
      return over;
    }
  };
  /// The byte stands on the line, behind its start bit: looked at in the middle of each bit.
  struct Checker {
    UInt<12> since = 0;     // clocks since the start bit began
    Hex<UInt<8>> byte = 0;  // the bits so far

    Bit checked(const Job& job, const Driver&, const Out& out, const Bit& over) {
      const Bit begun = since != 0 || !out.tx;
      for (int i = 0; i < 8; ++i) byte[i] |= out.tx && since == D * (i + 1) + D / 2;
      since = mux(begun, since + 1, 0);
      return over && byte != job.byte;
    }
  };
};
