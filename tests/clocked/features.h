// Models that use what the others do not.
#pragma once

#include <algorithm>

#include "model/clocked/model.h"

namespace cosim::clocked::test {

/// Structs in arrays, tables, wide registers, loops, switch, indices that may be outside.
struct Features {
  struct Entry {
    UInt<5> tag;
    Bit valid;
  };
  struct In {
    Entry entry;
    UInt<3> at;
    UInt<4> key;
    Array<UInt<7>, 3> words;
  };
  struct Out {
    UInt<5> tag;
    UInt<8> square, chosen, most, outside;
    Bit found;
    UInt<100> wide;
  };
  static constexpr Array<UInt<8>, 16> squares = {0,  1,  4,   9,   16,  25,  36,  49,
                                                 64, 81, 100, 121, 144, 169, 196, 225};

  Array<Entry, 5> entries = Entry{.tag = 3, .valid = 0};
  Unreset<Array<UInt<8>, 4>> bytes;
  At<"copied.bytes", Unreset<Array<UInt<8>, 4>>> copy;
  Auxiliary<UInt<2>> copies = 0;
  UInt<500> wide = 1;
  Int<70> sum = -1;

  Out clock(const In& in) {
    Out out{.tag = entries[in.at].tag,
            .square = squares[in.key],
            .chosen = 0,
            .most = 0,
            .outside = bytes[in.at],
            .found = 0,
            .wide = wide.slice<450, 351>()};
    for (int i = 0; i < 5; ++i) {
      if (entries[i].valid && entries[i].tag == in.entry.tag) {
        out.found = 1;
        break;
      }
    }
    switch (in.at.value()) {
      case 0:
        out.chosen = 17;
        break;
      case 3:
        out.chosen = in.key * in.key;
        [[fallthrough]];
      case 5:
        ++out.chosen;
        break;
      default:
        out.chosen = in.key;
    }
    out.most = std::max(bytes[0], bytes[1]);
    for (const UInt<7>& word : in.words) sum += word;
    copy = bytes;
    ++copies;
    entries[in.at] = in.entry;
    bytes[in.at] = in.words[1];
    bytes[in.key.slice<1, 0>()] += 3;
    wide = wide * 3 + cat(in.words[0], in.words[2]);
    if (in.key[0]) wide[in.key] = !wide[in.key];
    if (wide % 7 == 2 || in.at > 6) sum = sum * 5 / (in.key - 4);
    return out;
  }
};

/// N independent conditions behind each other: 5 ^ N ways, but for merge().
template <int N>
struct Valid {
  struct In {
    UInt<N> set, clear;
    Bit rst;
  };
  struct Out {
    UInt<8> count;
  };
  UInt<N> valid = 0;
  UInt<8> count = 0;

  Out clock(const In& in) {
    const Out out{.count = count};
    for (int i = 0; i < N; ++i) {
      merge(*this, [&] {
        if (in.set[i] && !valid[i]) {
          valid[i] = 1;
          ++count;
        } else if (in.clear[i] && valid[i]) {
          valid[i] = 0;
          --count;
        }
      });
    }
    if (in.rst) *this = Valid{};
    return out;
  }
};

}  // namespace cosim::clocked::test
