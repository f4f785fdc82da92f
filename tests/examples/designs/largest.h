// Golden model of largest.v, with numbers of C++, which no symbol can become.
#pragma once

#include <cosim/model.h>

#include <algorithm>

template <int FAULT>
struct Largest {
  struct In {
    Bit rst;    // begin anew at 0
    UInt<8> d;  // the next input
  };
  struct Out {
    UInt<8> most;  // the largest of the last four
  };
  static constexpr auto reset = active_high<&In::rst>;

  UInt<8> one = 0;    // the last input
  UInt<8> two = 0;    // the one before
  UInt<8> three = 0;  // and before
  UInt<8> four = 0;   // and before

  Out clock(const In& in) {
    const Out out{.most = std::max({int(one), int(two), int(three), int(four)})};
    if (in.rst) {
      *this = Largest{};
    } else {
      four = three;
      three = two;
      two = one;
      one = in.d;
    }
    return out;
  }
};
