// Golden model of onehot.sv, whose registers it does not have.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Onehot {
  struct In {
    Bit rst;  // to place 0
    Bit go;   // to the next one
  };
  struct Out {
    UInt<3> place;
    Bit last;  // the place is 4
  };
  static constexpr auto reset = active_high<&In::rst>;
  static constexpr std::array unobserved{"ring"};

  Auxiliary<UInt<3>> place = 0;  // 0 to 4

  Out clock(const In& in) {
    const Out out{.place = place, .last = place == 4};
    if (in.rst) {
      place = 0;
    } else if (in.go) {
      place = mux(place == 4, 0, place + 1);
    }
    return out;
  }
};
