// Golden model of grid.sv: the cells of row 0, then those of row 1.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Grid {
  struct In {
    Bit rst;
    Bit write;
    Bit row;
    UInt<2> column;
    UInt<4> d;
  };
  struct Out {
    UInt<4> q;
  };
  static constexpr auto reset = active_high<&In::rst>;

  Unreset<Array<UInt<4>, 6>> cells;
  UInt<4> q = 0;

  Out clock(const In& in) {
    const Out out{.q = q};
    const UInt<3> at = in.row * 3 + in.column;
    q = mux(in.rst || in.column == 3, 0, cells[at]);
    if (in.write && in.column != 3) cells[at] = in.d;
    return out;
  }
};
