// Golden model of folded.v.
#pragma once

#include <cosim/model.h>

template <int FAULT, int TAGS, int DROPS>
struct Folded {
  using Word = Hex<UInt<4>>;
  struct In {
    Bit rst;
    Word d;
    Bit valid;
  };
  struct Out {
    Word q, tag;
    Bit dropped, bad;
  };
  static constexpr auto reset = active_high<&In::rst>;

  Unreset<Word> q;
  At<"tags.held", Unreset<Word>> held;  // drives nothing without TAGS
  Bit dropped = 0;                      // 0 without DROPS
  Bit bad = 0;                          // the same
  UInt<2> count = 0;

  Out clock(const In& in) {
    const Out out{.q = q, .tag = mux(TAGS, held, 0), .dropped = dropped, .bad = bad};
    dropped = bad = in.valid && count == 3 && DROPS != 0;
    if (in.valid) {
      q = in.d;
      held = in.d;
      ++count;
    }
    if (in.rst) {
      dropped = 0;
      bad = 0;
      count = 0;
    }
    return out;
  }
};
