// Golden model of uart.v.
#pragma once

#include "model/core/design.h"

namespace uart_model {

using namespace cosim;

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

/// What must be possible on a clock.
template <class V>
constexpr std::array<Stated<V>, 3> cases(const Params& p, const State<V>& s, const Inputs<V>& in) {
  return {{{"a byte is taken", (s.left == V(0)) & is_set(in.valid)},
           {"a stop bit ends", (s.left == V(1)) & (s.count == V(p.divider - 1))},
           {"a byte is stopped by a reset", !(s.left == V(0)) & !is_set(in.rst_n)}}};
}

#define UART_JOB(FIELD)                        \
  FIELD(idle, 0, 40, "clocks before the byte") \
  FIELD(byte, 0, 255, "what is sent after them")
COSIM_JOB(Job, UART_JOB, Params);

/// Waits, offers the byte until it is taken, and waits until it is out.
#define UART_DRIVER(FIELD)                     \
  FIELD(idled, 6, number, "", "clocks waited") \
  FIELD(taken, 1, flag, "", "the byte was taken")
COSIM_RECORD(Driver, UART_DRIVER, Params);

template <class V>
constexpr Inputs<V> drive(const Params&, const Job<V>& job, const Driver<V>& d, Inputs<V> in) {
  in.valid = flag<V>(!(d.idled < job.idle) & !is_set(d.taken));
  in.data = job.byte;
  return in;
}
template <class V>
constexpr cosim::Turn<Driver, V> driven(const Params&, const Job<V>& job, const Driver<V>& d,
                                        const Outputs<V>& out) {
  const Condition<V> waits = d.idled < job.idle, ready = is_set(out.ready);
  const Condition<V> over = is_set(d.taken) & ready;
  return {{select(waits, d.idled + V(1), d.idled), select(ready & !waits, V(1), d.taken)}, over};
}

/// The byte stands on the line, behind its start bit: looked at in the middle of each bit.
#define UART_CHECKER(FIELD)                                        \
  FIELD(since, 12, number, "", "clocks since the start bit began") \
  FIELD(byte, 8, bits, "", "the bits so far")
COSIM_RECORD(Checker, UART_CHECKER, Params);

template <class V>
constexpr cosim::Verdict<Checker, V> checked(const Params& p, const Job<V>& job, const Driver<V>&,
                                             const Checker<V>& c, const Outputs<V>& out,
                                             Condition<V> over) {
  const Condition<V> begun = !((c.since == V(0)) & is_set(out.tx));
  Checker<V> n{select(begun, c.since + V(1), V(0)), c.byte};
  for (int i = 0; i < 8; ++i) {
    const Condition<V> middle = c.since == V(p.divider * (i + 1) + p.divider / 2);
    n.byte = n.byte | select(middle, shift_left(out.tx, i), V(0));
  }
  const Condition<V> wrong = over & !(n.byte == job.byte);
  return {n, wrong};
}

struct Design {
  COSIM_DESIGN(uart_model);
  template <class V>
  using Job = uart_model::Job<V>;
  template <class V>
  using Driver = uart_model::Driver<V>;
  template <class V>
  using Checker = uart_model::Checker<V>;
  static constexpr const char* name = "uart";
  static constexpr Inputs<Word> rest() { return {.rst_n = 1}; }
  static constexpr Inputs<Word> reset_inputs() { return {.rst_n = 0}; }
  static constexpr std::array<Parameter, 1> parameters(const Params& p) {
    return {{{"D", p.divider}}};
  }
};

}  // namespace uart_model
