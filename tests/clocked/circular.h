// Golden model of rtl/circular, the circular interpolator of SU 1665343.
#pragma once

#include "model/clocked/model.h"

namespace cosim::clocked::test {

/// W: bits of a coordinate, 2 to 32.
template <int W>
struct Circular {
  using Count = OnesComplement<W + 1>;
  struct In {
    Bit rst, load;
    Source<"29", Int<W + 2>> f;  // floor of F at the start
    Source<"30", Count> ct7;     // Y in sector 1, X - 1 in sector 2
    Source<"31", Count> ct8;     // X - Y - 1 in sector 1, X - Y in sector 2
    Bit sector2, start, stop;
  };
  struct Out {
    Bit running;
    Bit step_y, step_x;  // Y + 1 and X - 1 on this clock
  };

  Source<"4", Bit> t4 = 0;
  Source<"16", Bit> t16 = 0;                       // sector 2
  Source<"1", OnesComplement<W + 4, true>> f = 3;  // evaluation function F, in quarters
  Source<"7", Count> ct7 = 0;
  Source<"8", Count> ct8 = 0;

  Out clock(const In& in) {
    const Bit finish = t4 && ct7 < 0;
    const Bit correct = t4 && !t16 && ct8 < 0;
    const Bit step = t4 && !finish && !correct && !in.stop;
    const Bit diagonal = t16 == (f > 0);
    const Out out{
        .running = t4, .step_y = step && (diagonal || !t16), .step_x = step && (diagonal || t16)};
    if (in.rst || in.stop || finish) {
      *this = Circular{};
    } else if (!t4) {
      idle(in);
    } else if (correct) {
      into_sector2();
    } else {
      advance(diagonal);
    }
    return out;
  }

  void idle(const In& in) {
    if (in.load) {
      f = (in.f << 2) + 3;
      ct7 = in.ct7;
      ct8 = in.ct8;
    }
    t4 = in.start;
    t16 = t16 || in.sector2;
  }

  // F gains X + Y; CT7 passes from Y to X - 1, CT8 from X - Y - 1 to X - Y, which is 0 or -1.
  void into_sector2() {
    const Bit level = ct8[0];
    const Int<W + 2> x = ct7 - !level;
    f = f + (Int<W + 3>(x + x + !level) << 2);
    ct7 = x - 1;
    ct8 = mux(level, 0, -1);
    t16 = 1;
  }

  void advance(Bit diagonal) {
    ct7 = mux(t16, ct7 - 1, ct7 + 1);
    ct8 = ct8 - mux(diagonal, 2, 1);
    const Int<W + 2> twice7 = ct7 + ct7, twice8 = ct8 + ct8;
    Int<W + 3> gain = 0;
    if (diagonal) {
      gain = mux(!t16, twice8 + 1, mux(ct8 < 0, twice8 - 1, twice8));
    } else {
      gain = mux(t16, twice7 + 1, mux(ct7 < 0, -twice7, -1 - twice7));
    }
    f = f + (gain << 2);
  }
};

}  // namespace cosim::clocked::test
