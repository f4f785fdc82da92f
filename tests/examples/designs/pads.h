// Golden model of pads.v.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Pads {
  struct In {
    Bit rst;                            // begin anew
    Hex<UInt<2>> pull;                  // pads that pull the line down from the next clock
    Bit give;                           // drive the bus from the next clock
    Hex<UInt<4>> value;                 // with this
    Bit clk;                            // goes to the clock buffer
    At<"sda$in", Bit> sda_in;           // the line, where no pad pulls
    At<"bus$in", Hex<UInt<4>>> bus_in;  // the bus, where it is not driven
  };
  struct Out {
    At<"sda$out", Bit> sda_out;           // what the pads give
    At<"sda$en", Bit> sda_en;             // one of them pulls
    At<"bus$out", Hex<UInt<4>>> bus_out;  // what is driven, and 0 else
    At<"bus$en", Hex<UInt<4>>> bus_en;    // the bits that are driven
    At<"buffer$I", Bit> before;           // the clock before its buffer
    Bit lost;                             // somebody else pulled the line down
    Hex<UInt<4>> seen;                    // what stood on the bus
  };
  static constexpr auto reset = active_high<&In::rst>;

  Hex<UInt<2>> low = 0;   // pads that pull
  Bit giving = 0;         // the bus is driven
  Hex<UInt<4>> seen = 0;  // what stood on the bus
  Bit lost = 0;           // the line was pulled down

  Out clock(const In& in) {
    const Out out{.sda_out = 0,
                  .sda_en = low != 0,
                  .bus_out = mux(giving, seen, 0),
                  .bus_en = mux(giving, 15, 0),
                  .before = in.clk,
                  .lost = lost,
                  .seen = seen};
    if (in.rst) {
      *this = Pads{};
    } else {
      lost = low == 0 && !in.sda_in;
      seen = mux(in.give, in.value, mux(giving, seen, in.bus_in));
      low = in.pull;
      giving = in.give;
    }
    return out;
  }
};
