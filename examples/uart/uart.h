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
struct Driver {
  Params p;
  Job job;
  Word idled = 0;
  bool offered = false, taken = false;

  bool next(Inputs<Word>& in, const Outputs<Word>& seen) {
    if (idled++ < job.idle) return true;
    if (taken && seen.ready == 1) return false;
    taken = taken || (offered && seen.ready == 1);
    offered = true;
    in.valid = taken ? 0 : 1;
    in.data = job.byte;
    return true;
  }
};

/// The byte stands on the line, behind its start bit: looked at in the middle of each bit.
struct Check {
  Params p;
  Job job;
  Word since = 0, byte = 0;  // clocks since the start bit began; the bits so far

  void clock(const Outputs<Word>& out) {
    if (since == 0 && out.tx == 1) return;
    const Word bit = since / p.divider - 1;
    if (since % p.divider == p.divider / 2 && bit >= 0 && bit < 8) byte += out.tx << bit;
    ++since;
  }
  std::string wrong() const {
    return byte == job.byte ? "" : "the line had " + std::to_string(byte);
  }
};

struct Design {
  COSIM_DESIGN(uart);
  using Job = uart::Job;
  using Driver = uart::Driver;
  using Check = uart::Check;
  static constexpr const char* name = "uart";
  static constexpr Inputs<Word> rest() { return {.rst_n = 1}; }
  static constexpr Inputs<Word> reset_inputs() { return {.rst_n = 0}; }
  static constexpr std::array<Parameter, 1> parameters(const Params& p) {
    return {{{"D", p.divider}}};
  }
};

}  // namespace cosim::uart
