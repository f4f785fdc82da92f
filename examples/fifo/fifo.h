// Golden model of fifo.v.
#pragma once

#include <cosim/model.h>

#include <bit>

/// WIDTH: bits of a word, 1 to 64. DEPTH: words, 2 to 16.
template <int WIDTH, int DEPTH>
struct Fifo {
  static constexpr int BITS = int(std::bit_width(DEPTH - 1u));  // of a number below DEPTH
  using Word = Hex<UInt<WIDTH>>;
  using Index = UInt<BITS>;
  struct In {
    Bit rst;        // empties it
    Bit in_valid;   // there is a word
    Word in_data;   // the word
    Bit out_ready;  // a word can be taken
  };
  struct Out {
    Bit in_ready;   // there is room for a word
    Bit out_valid;  // there is a word
    Word out_data;  // the oldest
  };
  static constexpr auto reset = active_high<&In::rst>;

  Index head = 0;                     // where the oldest word is
  Index tail = 0;                     // where the next one goes
  UInt<BITS + 1> count = 0;           // words in it
  Unreset<Array<Word, DEPTH>> store;  // the words, in a circle

  static Index after(const Index& i) { return mux(i == DEPTH - 1, 0, i + 1); }

  Out clock(const In& in) {
    const Out out{.in_ready = count != DEPTH, .out_valid = count != 0, .out_data = store[head]};
    const Bit push = in.in_valid && out.in_ready, pop = out.out_valid && in.out_ready;
    if (push) store[tail] = in.in_data;
    if (in.rst) {
      head = 0;
      tail = 0;
      count = 0;
    } else {
      if (pop) head = after(head);
      if (push) tail = after(tail);
      count = count + push - pop;
    }
    return out;
  }

  /// What stands at the output of an empty queue means nothing.
  auto compared(const In&, const Out& out) const { return stated({{"out_data", out.out_valid}}); }
};
