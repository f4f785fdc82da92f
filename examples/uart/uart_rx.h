// Golden model of uart_rx.v.
#pragma once

#include "model/core/design.h"

namespace uart_rx_model {

using namespace cosim;

struct Params {
  int divider;  ///< clocks a bit, 4 to 256
};

#define UART_RX_INPUTS(FIELD)                  \
  FIELD(rst_n, 1, flag, "", "0: stop at once") \
  FIELD(rx, 1, flag, "", "the line")
#define UART_RX_OUTPUTS(FIELD)                                \
  FIELD(valid, 1, flag, "", "a byte has come")                \
  FIELD(error, 1, flag, "", "one has, but its stop bit is 0") \
  FIELD(data, 8, bits, "", "the byte")
#define UART_RX_STATE(FIELD)                                                \
  FIELD(sync, 2, bits.unreset(), "", "the line on the last two clocks")     \
  FIELD(left, 4, number, "", "bits of the frame still to come")             \
  FIELD(count, 8, number.unreset(), "", "clocks to the middle of the next") \
  FIELD(frame, 9, bits.unreset(), "", "the last bits, the newest highest")  \
  FIELD(done, 1, flag, "", "the frame is whole")
COSIM_RECORDS(UART_RX, Params);

template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  using Flag = Condition<V>;
  const Flag line = bit(s.sync, 1), good = bit(s.frame, 8), done = is_set(s.done);
  const Flag idle = s.left == V(0), run = is_set(in.rst_n);
  const Flag start = idle & !line, sample = !idle & (s.count == V(0));
  const V left = select((s.left == V(10)) & line, V(0), s.left - V(1));

  Step<V> step;
  step.outputs = {flag<V>(done & good), flag<V>(done & !good), slice(s.frame, 7, 0)};
  step.state.sync = join(slice(s.sync, 0, 0), in.rx, 1);
  step.state.left = select(run, select(start, V(10), select(sample, left, s.left)), V(0));
  step.state.count = select(start, V(p.divider / 2 - 1),
                            select(sample, V(p.divider - 1), wrap(s.count - V(1), 8)));
  step.state.frame = select(sample, join(flag<V>(line), slice(s.frame, 8, 1), 8), s.frame);
  step.state.done = flag<V>(run & sample & (s.left == V(1)));
  return step;
}

struct Design {
  COSIM_DESIGN(uart_rx_model);
  static constexpr const char* name = "uart_rx";
  static constexpr Inputs<Word> rest() { return {.rst_n = 1, .rx = 1}; }
  static constexpr Inputs<Word> reset_inputs() { return {.rst_n = 0, .rx = 1}; }
  static constexpr std::array<Parameter, 1> parameters(const Params& p) {
    return {{{"D", p.divider}}};
  }
};

}  // namespace uart_rx_model
