// Golden model of wires.v.
#pragma once

#include <cosim/model.h>

/// W: 65 to 128. D: 1 to 8.
template <int FAULT, int W, int D>
struct Wires {
  using Byte = Hex<UInt<8>>;
  using Half = Hex<UInt<4>>;
  struct In {
    Bit rst, write;
    UInt<3> index;
    Hex<UInt<W>> d;
  };
  struct Out {
    Hex<UInt<W>> q;
    At<"mixed[7:0]", Byte> from_a;
    At<"mixed[19:8]", Array<Half, 3>> from_bc;
  };
  static constexpr auto reset = active_high<&In::rst>;

  static Array<UInt<5>, D> numbers() {
    Array<UInt<5>, D> all = 0;
    for (int i = 0; i < D; ++i) all[i] = i;
    return all;
  }

  Hex<UInt<W>> held = 0;
  At<"status[3:0]", UInt<4>> clocks = 0;
  At<"status[8:4]", UInt<5>> writes = 0;
  At<"status[9]", Bit> top = 0;
  Unreset<Array<Hex<UInt<64>>, 8>> lines;  // four of two words
  Array<UInt<5>, D> order = numbers();
  Unreset<Array<Half, 2>> pair;  // words 6 and 7
  At<"a.last", Unreset<Byte>> a;
  At<"b.last", Unreset<Byte>> b;
  At<"more[2].c.last", Unreset<Byte>> c;

  Out clock(const In& in) {
    const Out out{.q = held, .from_a = a, .from_bc = {b, b >> 4, c}};
    const UInt<2> line = in.index;
    c = (b ^ order[D - 1] ^ pair[1]) + 3;
    b = a + 3;
    a = in.d + 3;
    held = in.d;
    ++clocks;
    writes += in.write;
    top = lines[cat(line, Bit(1))][63];
    if (in.write) {
      const UInt<128> both_words = cat(UInt<28>(in.d), in.d);
      lines[cat(line, Bit(0))] = both_words;
      lines[cat(line, Bit(1))] = both_words >> 64;
      order[in.index] = in.d;
      pair[in.index[1]] = in.d >> 4;
    }
    if (in.rst) {
      held = 0;
      clocks = 0;
      writes = 0;
      top = 0;
      order = numbers();
    }
    return out;
  }
};
