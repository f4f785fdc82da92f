// Golden model of crossing.sv.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Crossing {
  struct In {
    Bit rst;   // begin with red
    Bit walk;  // somebody wants to walk
  };
  struct Out {
    Hex<UInt<2>> light;  // 0 red, 1 green, 2 amber
    Bit stays;           // it does not change this clock
  };
  static constexpr auto reset = active_high<&In::rst>;
  enum Light { red, green, amber };

  static UInt<6> begun(Light light) { return cat(UInt<2>(light), UInt<4>(light == amber ? 2 : 9)); }

  Hex<UInt<6>> now = begun(red);  // the light above the clocks left, four bits

  Out clock(const In& in) {
    const UInt<2> light = now.slice<5, 4>();
    const UInt<4> left = now.slice<3, 0>();
    const Out out{.light = light, .stays = left != 0};
    if (in.rst) {
      now = begun(red);
    } else if (out.stays) {
      now.slice<3, 0>() = left - 1;
    } else if (light == red) {
      now = begun(green);
    } else if (light == green) {
      if (in.walk) now = begun(amber);
    } else {
      now = begun(red);
    }
    return out;
  }
};
