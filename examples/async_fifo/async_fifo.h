// Golden model of async_fifo.v.
#pragma once

#include "model/core/design.h"
#include "model/core/memory.h"
#include "model/core/stream.h"

namespace async_fifo_model {

using namespace cosim;

struct Params {
  int width;  ///< bits of a word, 1 to 64
  int bits;   ///< of a word's number in the queue, 2 to 4

  constexpr int words() const { return 1 << bits; }
  constexpr int count() const { return bits + 1; }
};

#define ASYNC_FIFO_INPUTS(FIELD)                                                                  \
  FIELD(rst_n, 1, flag, "", "0 empties it")                                                       \
  FIELD(w_clk, 1, rises, "", "the writer's clock")                                                \
  FIELD(w_valid, 1, flag, "", "there is a word")                                                  \
  FIELD(w_data, p.width, bits, "", "the word")                                                    \
  FIELD(r_clk, 1, rises, "", "the reader's clock")                                                \
  FIELD(r_ready, 1, flag, "", "a word can be taken")                                              \
  FIELD(r_first_new, p.count(), bits.synchronizer("r_first"), "", "bits that take the new value") \
  FIELD(w_first_new, p.count(), bits.synchronizer("w_first"), "", "bits that take the new value")
#define ASYNC_FIFO_OUTPUTS(FIELD)                         \
  FIELD(w_ready, 1, flag, "", "there is room for a word") \
  FIELD(r_valid, 1, flag, "", "there is a word")          \
  FIELD(r_data, p.width, bits, "", "the oldest")
#define ASYNC_FIFO_STATE(FIELD)                                             \
  FIELD(w_count, p.count(), number, "", "words that went in")               \
  FIELD(w_gray, p.count(), bits, "", "the same in Gray code")               \
  FIELD(r_first, p.count(), bits, "", "r_gray, at the writer, a clock ago") \
  FIELD(r_seen, p.count(), bits, "", "the same, two clocks ago")            \
  FIELD(r_count, p.count(), number, "", "words that came out")              \
  FIELD(r_gray, p.count(), bits, "", "the same in Gray code")               \
  FIELD(w_first, p.count(), bits, "", "w_gray, at the reader, a clock ago") \
  FIELD(w_seen, p.count(), bits, "", "the same, two clocks ago")            \
  FIELD(store, p.width, bits.array<16>(p.words()).unreset(), "", "the words, in a circle")
COSIM_RECORDS(ASYNC_FIFO, Params);

template <class V>
constexpr V gray_of(V count) {
  return count ^ shift_right(count, 1);
}

template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  const auto w_ready = !(s.w_gray == (s.r_seen ^ V(3 << (p.bits - 1))));
  const auto r_valid = !(s.r_gray == s.w_seen);
  const auto push = is_set(in.w_valid) & w_ready, pop = is_set(in.r_ready) & r_valid;
  Step<V> step{s, {flag<V>(w_ready), flag<V>(r_valid), read(s.store, wrap(s.r_count, p.bits))}};

  State<V> w = step.state;  // where w_clk rises
  w.store = write_where(push, s.store, wrap(s.w_count, p.bits), in.w_data);
  w.w_count = wrap(s.w_count + flag<V>(push), p.count());
  w.w_gray = gray_of(w.w_count);
  w.r_first = s.r_gray;
  w.r_seen = s.r_first;
  step.state = select(is_set(in.w_clk), w, step.state);

  State<V> r = step.state;  // where r_clk rises
  r.r_count = wrap(s.r_count + flag<V>(pop), p.count());
  r.r_gray = gray_of(r.r_count);
  r.w_first = s.w_gray;
  r.w_seen = s.w_first;
  step.state = select(is_set(in.r_clk), r, step.state);
  return step;
}

/// What stands at the output of an empty queue means nothing.
template <class V>
constexpr auto compared(const Params&, const State<V>&, const Inputs<V>&, const Outputs<V>& out) {
  return std::array{Stated<V>{"r_data", is_set(out.r_valid)}};
}

/// What goes through it.
#define ASYNC_FIFO_ITEM(FIELD) FIELD(data, p.width, bits, "", "a word")
COSIM_RECORD(Item, ASYNC_FIFO_ITEM, Params);

struct Design {
  COSIM_DESIGN(async_fifo_model);
  static constexpr const char* name = "async_fifo";
  static constexpr Inputs<Word> rest() { return {.rst_n = 1}; }
  static constexpr Inputs<Word> reset_inputs() { return {}; }
  static constexpr bool asynchronous_reset = true;
  static constexpr std::array<Parameter, 2> parameters(const Params& p) {
    return {{{"WIDTH", p.width}, {"BITS", p.bits}}};
  }

  // As a stream, whose two sides have each a clock of their own: all that goes in comes out.
  static constexpr auto in(const Params&) { return stream<Item>("w").clock("w_clk"); }
  static constexpr auto out(const Params&) { return stream<Item>("r").clock("r_clk"); }
  static constexpr auto pins(const Params&) { return std::array{pin::reset_low("rst_n")}; }
  static std::vector<Item<Word>> run(const Params&, const std::vector<Item<Word>>& in) {
    return in;
  }
};

}  // namespace async_fifo_model
