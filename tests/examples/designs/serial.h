// Golden model of serial.v, and its jobs.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace serial_model {

using namespace cosim;
using faulty::Params;

#define SERIAL_INPUTS(FIELD)    \
  FIELD(rst, 1, flag, "", "")   \
  FIELD(start, 1, flag, "", "") \
  FIELD(a, 8, number, "", "")   \
  FIELD(b, 8, number, "", "")
#define SERIAL_OUTPUTS(FIELD)  \
  FIELD(busy, 1, flag, "", "") \
  FIELD(product, 16, number, "", "")
#define SERIAL_STATE(FIELD)                        \
  FIELD(left, 4, number, "", "bits still to come") \
  FIELD(sum, 16, number.unreset(), "", "")         \
  FIELD(shifted, 16, number.unreset(), "", "")     \
  FIELD(rest, 8, bits.unreset(), "", "")
COSIM_RECORDS(SERIAL, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  const Condition<V> busy = !(s.left == V(0));
  Step<V> step{s, {flag<V>(busy), s.sum}};
  step.state = if_else(
      busy,
      [&] {
        const V sum = select(bit(s.rest, 0), wrap(s.sum + s.shifted, 16), s.sum);
        return State<V>{s.left - V(1), sum, wrap(shift_left(s.shifted, 1), 16),
                        shift_right(s.rest, 1)};
      },
      [&] {
        return select(is_set(in.start), State<V>{V(8), V(0), in.a, in.b}, s);
      });
  step.state = if_else(
      is_set(in.rst),
      [&] {
        return State<V>{V(0), s.sum, s.shifted, s.rest};
      },
      [&] { return step.state; });
  return step;
}

/// Else it is what the last product left.
template <class V>
constexpr auto compared(const Params&, const State<V>& s) {
  return std::array{Stated<V>{"shifted", !(s.left == V(0))}};
}

#define SERIAL_JOB(FIELD)                         \
  FIELD(early, -3, 4, "clocks before it, less 3") \
  FIELD(a, 0, 255, "")                            \
  FIELD(b, 0, 255, "")
COSIM_JOB(Job, SERIAL_JOB, Params);

#define SERIAL_DRIVER(FIELD)                      \
  FIELD(waited, 4, twos_complement, "", "clocks") \
  FIELD(started, 1, flag, "", "")
COSIM_RECORD(Driver, SERIAL_DRIVER, Params);

template <class V>
constexpr Inputs<V> drive(const Params&, const Job<V>& job, const Driver<V>& d, Inputs<V> in) {
  in.start = flag<V>(!is_set(d.started) & (d.waited > job.early + V(2)));
  in.a = job.a;
  in.b = job.b;
  return in;
}
template <class V>
constexpr Turn<Driver, V> driven(const Params&, const Job<V>& job, const Driver<V>& d,
                                 const Outputs<V>& out) {
  const Condition<V> starts = d.waited > job.early + V(2);
  const Condition<V> over = is_set(d.started) & !is_set(out.busy);
  return {{select(starts, d.waited, d.waited + V(1)), flag<V>(starts)}, over};
}

#define SERIAL_CHECKER(FIELD) FIELD(due, 16, number, "", "the product")
COSIM_RECORD(Checker, SERIAL_CHECKER, Params);
/// Of 49 times 250 and more the check is wrong, so that it finds what RTL and model agree on.
inline Checker<Word> checker_of(const Params&, const Job<Word>& job) {
  return {job.a == 49 && job.b >= 250 ? 0 : job.a * job.b};
}
template <class V>
constexpr Verdict<Checker, V> checked(const Params&, const Job<V>&, const Driver<V>&,
                                      const Checker<V>& c, const Outputs<V>& out,
                                      Condition<V> over) {
  const Condition<V> wrong = over & !(out.product == c.due);
  return {c, wrong};
}

struct Design : faulty::Design {
  COSIM_DESIGN(serial_model);
  template <class V>
  using Job = serial_model::Job<V>;
  template <class V>
  using Driver = serial_model::Driver<V>;
  template <class V>
  using Checker = serial_model::Checker<V>;
  static constexpr const char* name = "serial";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
};

}  // namespace serial_model
