// Golden model of wires.v.
#pragma once

#include "model/core/bit_strings.h"
#include "model/core/design.h"
#include "model/core/memory.h"

namespace wires_model {

using namespace cosim;

struct Params {
  int fault;
  int width;  ///< 65 to 128
  int depth;  ///< 1 to 8
};

#define WIRES_INPUTS(FIELD)       \
  FIELD(rst, 1, flag, "", "")     \
  FIELD(write, 1, flag, "", "")   \
  FIELD(index, 3, number, "", "") \
  FIELD(d, p.width, bits.words<2>(), "", "")
#define WIRES_OUTPUTS(FIELD)                      \
  FIELD(q, p.width, bits.words<2>(), "", "")      \
  FIELD(from_a, 8, bits.at("mixed[7:0]"), "", "") \
  FIELD(from_bc, 4, bits.array<3>().at("mixed[19:8]"), "", "")
#define WIRES_STATE(FIELD)                                             \
  FIELD(held, p.width, bits.words<2>(), "", "")                        \
  FIELD(clocks, 4, number.at("status[3:0]"), "", "")                   \
  FIELD(writes, 5, number.at("status[8:4]"), "", "")                   \
  FIELD(top, 1, flag.at("status[9]"), "", "")                          \
  FIELD(lines, 64, bits.array<8>().unreset(), "", "four of two words") \
  FIELD(order, 5, number.array<8>(p.depth), "", "")                    \
  FIELD(pair, 4, bits.array<2>().unreset(), "", "words 6 and 7")       \
  FIELD(a, 8, bits.at("a.last").unreset(), "", "")                     \
  FIELD(b, 8, bits.at("b.last").unreset(), "", "")                     \
  FIELD(c, 8, bits.at("more[2].c.last").unreset(), "", "")
COSIM_RECORDS(WIRES, Params);

template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  const auto rst = is_set(in.rst), write = is_set(in.write);
  const V line = low_bits(in.index, 2);
  const int over = p.width - 64;  // bits of d's second word
  Step<V> step{s, {s.held, s.a, {low_bits(s.b, 4), slice(s.b, 7, 4), low_bits(s.c, 4)}}};
  const V high = low_bits(join(low_bits(in.d[0], 28), in.d[1], over), 64);
  step.state.held = select(rst, Array<V, 2>{}, in.d);
  step.state.clocks = select(rst, V(0), wrap(s.clocks + V(1), 4));
  step.state.writes = select(rst, V(0), wrap(s.writes + in.write, 5));
  step.state.top = select(rst, V(0), flag<V>(bit(read(s.lines, line + line + V(1)), 63)));
  step.state.lines = write_where(write, s.lines, line + line, in.d[0]);
  step.state.lines = write_where(write, step.state.lines, line + line + V(1), high);
  const V ordered = low_bits(in.d[0], 5);
  for (int i = 0; i < p.depth; ++i) {
    V& order = step.state.order[i];
    order = select(rst, V(i), select(write & (in.index == V(i)), ordered, order));
  }
  const auto stepped = [](const V& v) { return wrap(v + V(3), 8); };
  step.state.a = stepped(low_bits(in.d[0], 8));
  step.state.b = stepped(s.a);
  step.state.c = stepped(s.b ^ s.order[p.depth - 1] ^ s.pair[1]);
  step.state.pair = write_where(write, s.pair, slice(in.index, 1, 1), slice(in.d[0], 7, 4));
  return step;
}

struct Design {
  COSIM_DESIGN(wires_model);
  static constexpr const char* name = "wires";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
  template <class V>
  static constexpr State<V> reset_state() {
    State<V> s;
    for (int i = 0; i < 8; ++i) s.order[i] = V(i);
    return s;
  }
  static constexpr std::array<Parameter, 3> parameters(const Params& p) {
    return {{{"FAULT", p.fault}, {"W", p.width}, {"D", p.depth}}};
  }
};

}  // namespace wires_model
