// Golden model of fifo.v.
#pragma once

#include "model/core/design.h"
#include "model/core/memory.h"

namespace fifo_model {

using namespace cosim;

struct Params {
  int width;  ///< bits of a word, 1 to 64
  int depth;  ///< words, 2 to 16

  /// Bits of a number below depth.
  constexpr int bits() const { return depth > 8 ? 4 : depth > 4 ? 3 : depth > 2 ? 2 : 1; }
};

#define FIFO_INPUTS(FIELD)                        \
  FIELD(rst, 1, flag, "", "empties it")           \
  FIELD(in_valid, 1, flag, "", "there is a word") \
  FIELD(in_data, p.width, bits, "", "the word")   \
  FIELD(out_ready, 1, flag, "", "a word can be taken")
#define FIFO_OUTPUTS(FIELD)                                \
  FIELD(in_ready, 1, flag, "", "there is room for a word") \
  FIELD(out_valid, 1, flag, "", "there is a word")         \
  FIELD(out_data, p.width, bits, "", "the oldest")
#define FIFO_STATE(FIELD)                                       \
  FIELD(head, p.bits(), number, "", "where the oldest word is") \
  FIELD(tail, p.bits(), number, "", "where the next one goes")  \
  FIELD(count, p.bits() + 1, number, "", "words in it")         \
  FIELD(store, p.width, bits.array<16>(p.depth).unreset(), "", "the words, in a circle")
COSIM_RECORDS(FIFO, Params);

template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  const auto in_ready = !(s.count == V(p.depth)), out_valid = !(s.count == V(0));
  const auto push = is_set(in.in_valid) & in_ready, pop = out_valid & is_set(in.out_ready);
  const auto after = [&](V i) { return select(i == V(p.depth - 1), V(0), i + V(1)); };

  Step<V> step{s, {flag<V>(in_ready), flag<V>(out_valid), read(s.store, s.head)}};
  step.state.store = write_where(push, s.store, s.tail, in.in_data);
  step.state.head = select(pop, after(s.head), s.head);
  step.state.tail = select(push, after(s.tail), s.tail);
  step.state.count = s.count + flag<V>(push) - flag<V>(pop);
  const auto rst = is_set(in.rst);
  step.state.head = select(rst, V(0), step.state.head);
  step.state.tail = select(rst, V(0), step.state.tail);
  step.state.count = select(rst, V(0), step.state.count);
  return step;
}

/// What stands at the output of an empty queue means nothing.
template <class V>
constexpr auto compared(const Params&, const State<V>&, const Inputs<V>&, const Outputs<V>& out) {
  return std::array{Stated<V>{"out_data", is_set(out.out_valid)}};
}

struct Design {
  COSIM_DESIGN(fifo_model);
  static constexpr const char* name = "fifo";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
  static constexpr std::array<Parameter, 2> parameters(const Params& p) {
    return {{{"WIDTH", p.width}, {"DEPTH", p.depth}}};
  }
};

}  // namespace fifo_model
