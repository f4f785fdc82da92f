// Both models of async_fifo.v: what it does on every clock, and what goes through it.
#pragma once

#include <cosim/stream.h>

/// WIDTH: bits of a word, 1 to 64. BITS: of a word's number in the queue, 2 to 4.
template <int WIDTH, int BITS>
struct AsyncFifo {
  using Word = Hex<UInt<WIDTH>>;
  using Count = UInt<BITS + 1>;
  using Gray = Hex<Count>;
  struct In {
    Bit rst_n;                             // 0 empties it
    Rises w_clk;                           // the writer's clock
    Bit w_valid;                           // there is a word
    Word w_data;                           // the word
    Rises r_clk;                           // the reader's clock
    Bit r_ready;                           // a word can be taken
    Sampled<"r_first", Gray> r_first_new;  // bits that take the new value
    Sampled<"w_first", Gray> w_first_new;  // bits that take the new value
  };
  struct Out {
    Bit w_ready;  // there is room for a word
    Bit r_valid;  // there is a word
    Word r_data;  // the oldest
  };
  static constexpr auto reset = active_low<&In::rst_n>;
  static constexpr bool asynchronous_reset = true;

  Count w_count = 0;                      // words that went in
  Gray w_gray = 0;                        // the same in Gray code
  Gray r_first = 0;                       // r_gray, at the writer, a clock ago
  Gray r_seen = 0;                        // the same, two clocks ago
  Count r_count = 0;                      // words that came out
  Gray r_gray = 0;                        // the same in Gray code
  Gray w_first = 0;                       // w_gray, at the reader, a clock ago
  Gray w_seen = 0;                        // the same, two clocks ago
  Unreset<Array<Word, 1 << BITS>> store;  // the words, in a circle

  Out clock(const In& in) {
    // As many words more than seen as there are places: in Gray code the first two bits differ.
    const Out out{.w_ready = w_gray != (r_seen ^ 3 << (BITS - 1)),
                  .r_valid = r_gray != w_seen,
                  .r_data = store[UInt<BITS>(r_count)]};
    const Gray w_before = w_gray;
    if (in.w_clk) {
      const Bit push = in.w_valid && out.w_ready;
      if (push) store[UInt<BITS>(w_count)] = in.w_data;
      w_count += push;
      w_gray = w_count ^ w_count >> 1;
      r_seen = r_first;
      r_first = r_gray;
    }
    if (in.r_clk) {
      r_count += in.r_ready && out.r_valid;
      r_gray = r_count ^ r_count >> 1;
      w_seen = w_first;
      w_first = w_before;
    }
    return out;
  }

  /// What stands at the output of an empty queue means nothing.
  auto compared(const In&, const Out& out) const { return stated({{"r_data", out.r_valid}}); }

  /// What goes through it: a stream whose two sides have each a clock of their own.
  struct Item {
    Word data;  // a word
  };
  static constexpr auto in() { return stream<Item>("w").clock("w_clk"); }
  static constexpr auto out() { return stream<Item>("r").clock("r_clk"); }
  static constexpr auto pins() { return std::array{pin::reset_low("rst_n")}; }
  static std::vector<Item> run(const std::vector<Item>& in) { return in; }
};
