// Golden model of pipe.v.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace pipe_model {

using namespace cosim;
using faulty::Params;

#define PIPE_INPUTS(FIELD)                       \
  FIELD(rst, 1, flag, "", "forget all numbers")  \
  FIELD(valid, 1, flag, "", "there is a number") \
  FIELD(data, 6, number, "", "the number")
#define PIPE_OUTPUTS(FIELD)                     \
  FIELD(done, 1, flag, "", "there is a square") \
  FIELD(result, 8, number, "", "the square, modulo 256")
#define PIPE_STATE(FIELD)                       \
  FIELD(busy, 1, flag, "", "there is a number") \
  FIELD(last, 1, flag, "", "there is a square") \
  FIELD(number, 6, number, "", "the number")    \
  FIELD(square, 8, number, "", "the square, modulo 256")
COSIM_RECORDS(PIPE, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  V square = V(0);
  for (int i = 0; i < 6; ++i) {
    square = square + select(bit(s.number, i), shift_left(s.number, i), V(0));
  }
  // Where there is no number the RTL has any other value.
  return {{select(is_set(in.rst), V(0), in.valid), select(is_set(in.rst), V(0), s.busy),
           select(is_set(in.valid), in.data, V(0)), wrap(square, 8)},
          {s.last, s.square}};
}

template <class V>
constexpr auto compared(const Params&, const State<V>& s) {
  return std::array{Stated<V>{"number", is_set(s.busy)}, Stated<V>{"square", is_set(s.last)}};
}
template <class V>
constexpr auto compared(const Params&, const State<V>&, const Inputs<V>&, const Outputs<V>& out) {
  return std::array{Stated<V>{"result", is_set(out.done)}};
}

struct Design : faulty::Design {
  COSIM_DESIGN(pipe_model);
  static constexpr const char* name = "pipe";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
};

}  // namespace pipe_model
