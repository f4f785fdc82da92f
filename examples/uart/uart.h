// Golden model of uart.v.
#pragma once

#include "model/core/design.h"

namespace cosim::uart {

struct Params {
  int divider;  ///< clocks a bit, 1 to 256
};

#define UART_INPUTS(FIELD)                             \
  FIELD(rst_n, 1, flag, "", "0: stop at once")         \
  FIELD(valid, 1, flag, "", "there is a byte to send") \
  FIELD(data, 8, bits, "", "the byte")
#define UART_OUTPUTS(FIELD)                          \
  FIELD(ready, 1, flag, "", "a byte would be taken") \
  FIELD(tx, 1, flag, "", "the line")
#define UART_STATE(FIELD)                                              \
  FIELD(left, 4, number, "", "bits of the frame still to come")        \
  FIELD(frame, 9, bits.unreset(), "", "what is left, the next lowest") \
  FIELD(count, 8, number.at("divider.count"), "", "clocks of this bit")
COSIM_RECORDS(UART, Params);

template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  using Flag = Condition<V>;
  const Flag reset = !is_set(in.rst_n);
  const Flag ready = s.left == V(0);
  const Flag accept = ready & is_set(in.valid);
  const Flag tick = s.count == V(p.divider - 1);
  const Flag shift = tick & !ready;

  Step<V> step;
  step.outputs.ready = flag<V>(ready);
  step.outputs.tx = flag<V>(ready | bit(s.frame, 0));
  step.state.left =
      select(reset, V(0), select(accept, V(10), select(shift, wrap(s.left - V(1), 4), s.left)));
  step.state.frame = select(reset, s.frame,
                            select(accept, shift_left(in.data, 1),
                                   select(shift, shift_right(s.frame, 1) + V(0x100), s.frame)));
  step.state.count = select(reset | accept | tick, V(0), wrap(s.count + V(1), 8));
  return step;
}

struct Design {
  COSIM_DESIGN(uart);
  static constexpr const char* name = "uart";
  static constexpr Inputs<Word> rest() { return {.rst_n = 1}; }
  static constexpr Inputs<Word> clear() { return {.rst_n = 0}; }
  static constexpr std::array<Parameter, 1> parameters(const Params& p) {
    return {{{"D", p.divider}}};
  }
};

}  // namespace cosim::uart
