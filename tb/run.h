// Runs a stimulus in lockstep. Nothing is recorded on the way: a case that fails is run again from
// its start, which its seed makes the same, with every signal of the clocks around the difference
// kept.
#pragma once

#include <cstdint>
#include <optional>

#include "tb/lockstep.h"
#include "tb/mismatch.h"

namespace cosim {

/// What came of one case.
struct Run {
  std::uint64_t clocks = 0;  ///< clocks compared, the differing one included
  std::optional<Mismatch> mismatch;
};

/// The clocks shown before and after the first difference.
struct Window {
  std::uint64_t before = 8;
  std::uint64_t after = 4;
};

namespace detail {

template <class Record, class Params>
void add_traces(Mismatch& m, Trace::Kind kind, const Params& p) {
  for (const Field& f : Record::fields(p)) m.traces.push_back({f, kind, {}, {}});
}

template <class Record>
void add_clock(Mismatch& m, std::size_t& at, const Record& expected, const Record& actual) {
  const Words<Record> e = to_words(expected);
  const Words<Record> a = to_words(actual);
  for (std::size_t i = 0; i < Record::size; ++i, ++at) {
    m.traces[at].expected.push_back(e[i]);
    m.traces[at].actual.push_back(a[i]);
    if (e[i] != a[i] && m.signal.empty()) {
      m.signal = m.traces[at].field.name;
      m.field = m.traces[at].field;
      m.expected = e[i];
      m.actual = a[i];
    }
  }
}

}  // namespace detail

/// Runs the same case again up to `after` clocks past clock `clock` and keeps the window.
template <class Adapter, class Stimulus>
Mismatch examine(Stimulus stimulus, std::uint32_t power_up, std::uint64_t clock, Window window) {
  using Design = typename Adapter::Design;
  Mismatch m;
  m.clock = clock;
  m.first = clock > window.before ? clock - window.before : 0;
  detail::add_traces<typename Design::template Inputs<Word>>(m, Trace::Kind::input,
                                                             Adapter::params);
  detail::add_traces<typename Design::template Registers<Word>>(m, Trace::Kind::reg,
                                                                Adapter::params);
  detail::add_traces<typename Design::template Outputs<Word>>(m, Trace::Kind::output,
                                                              Adapter::params);

  Lockstep<Adapter> lockstep(power_up);
  typename Design::template Inputs<Word> in;
  for (std::uint64_t c = 0; c <= clock + window.after; ++c) {
    if (!stimulus.next(in, lockstep.expected().outputs)) break;
    const bool same = lockstep.clock(in);
    if (c < m.first) continue;
    const Compared<Design>& expected = lockstep.expected();
    const Compared<Design>& actual = same ? expected : lockstep.actual();
    std::size_t at = 0;
    detail::add_clock(m, at, in, in);
    detail::add_clock(m, at, expected.registers, actual.registers);
    detail::add_clock(m, at, expected.outputs, actual.outputs);
  }
  return m;
}

/// Clocks `lockstep` from `source` until the source ends (true) or RTL and model differ (false),
/// and counts the clocks, the differing one included. `observe(source, compared)` is called after
/// each clock that matched.
template <class Adapter, class Stimulus, class Observe>
bool clock_through(Lockstep<Adapter>& lockstep, Stimulus& source, std::uint64_t& clocks,
                   Observe&& observe) {
  typename Adapter::Design::template Inputs<Word> in;
  while (source.next(in, lockstep.expected().outputs)) {
    ++clocks;
    if (!lockstep.clock(in)) return false;
    observe(source, lockstep.expected());
  }
  return true;
}

/// Runs a stimulus on a machine of its own, to its end or to the first difference.
template <class Adapter, class Stimulus>
Run run(const Stimulus& stimulus, std::uint32_t power_up) {
  Run result;
  Stimulus source = stimulus;
  Lockstep<Adapter> lockstep(power_up);
  if (!clock_through(lockstep, source, result.clocks, [](const auto&, const auto&) {})) {
    result.mismatch = examine<Adapter>(stimulus, power_up, result.clocks - 1, Window{});
  }
  return result;
}

}  // namespace cosim
