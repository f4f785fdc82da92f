// Runs a stimulus in lockstep. Nothing is recorded on the way.
//
// A failing case is run again by its seed, with every signal around the difference recorded.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tb/dut/dut.h"
#include "tb/nets/legal.h"
#include "tb/sim/cells.h"
#include "tb/sim/lockstep.h"
#include "tb/sim/mismatch.h"
#include "tb/sim/transactions.h"

namespace cosim {

/// What came of one case.
struct Run {
  std::uint64_t clocks = 0;  ///< clocks compared, the differing one included
  /// Of each register, then of each output, on how many of them it was left out; may be empty.
  std::vector<std::uint64_t> left_out{};
  std::optional<Mismatch> mismatch;
  std::vector<Transactions> streams{};  ///< as BenchTables::streams; empty of a run in lockstep
  /// How often each of BenchTables::cases happened.
  std::vector<std::uint64_t> happened{};
};

/// Lockstep whose DUT stands behind virtual calls: one class for all shapes of a design.
template <class Design>
using AnyLockstep = Lockstep<AnyAdapter<Design>>;

namespace detail {

template <class Record>
void add_traces(Mismatch& m, Trace::Kind kind, const Cells<Record>& cells) {
  for (const Field& f : cells.fields()) m.traces.push_back({f, kind, {}, {}});
}

// is_compared(i) says it of the record's cell i.
template <class Record, class IsCompared>
void add_clock(Mismatch& m, std::size_t& at, const Cells<Record>& cells, const Record& expected,
               const Record& actual, IsCompared is_compared) {
  const std::vector<Word> e = cells.words(expected);
  const std::vector<Word> a = cells.words(actual);
  for (std::size_t i = 0; i < e.size(); ++i, ++at) {
    m.traces[at].expected.push_back(e[i]);
    m.traces[at].actual.push_back(a[i]);
    m.traces[at].left_out.push_back(!is_compared(i));
    if (m.traces[at].differs(m.traces[at].actual.size() - 1) && m.signal.empty()) {
      m.signal = label_of(m.traces[at].field);
      m.field = m.traces[at].field;
      m.expected = e[i];
      m.actual = a[i];
    }
  }
}

}  // namespace detail

/// A stimulus keeps at most so many clocks before the difference. A longer one starts from the
/// state that the model had then: up to there RTL and model were the same.
inline constexpr std::uint64_t most_kept = 1U << 20;

/// Runs a failing case again: clocks `lockstep`, which has just started, through `source` until
/// `window.after` clocks past `clock`, the first that differs. Keeps every signal of the window,
/// and the inputs of the longer range that a wave shows. InputError, which names `title`, where
/// they do not differ on that clock now, or sooner.
template <class Design>
[[gnu::cold]] Mismatch examine(AnyLockstep<Design>& lockstep, const InputSource<Design>& source,
                               std::uint64_t clock, Window window, const std::string& title) {
  const auto& p = lockstep.dut().params;
  Mismatch m;
  m.clock = clock;
  m.first = clock > window.before ? clock - window.before : 0;
  const Cells<typename Design::template Inputs<Word>> inputs(p);
  const Cells<typename Design::template Registers<Word>> registers(p);
  const Cells<typename Design::template Outputs<Word>> outputs(p);
  detail::add_traces(m, Trace::Kind::input, inputs);
  detail::add_traces(m, Trace::Kind::reg, registers);
  detail::add_traces(m, Trace::Kind::output, outputs);

  const std::uint64_t kept = clock > most_kept ? clock - most_kept : 0;
  typename Design::template Inputs<Word> in;
  for (std::uint64_t c = 0; c <= clock + Mismatch::clocks_behind; ++c) {
    if (c == kept && c != 0) {
      m.stimulus.state = Cells<typename Design::template State<Word>>(p).words(lockstep.state());
    }
    if (!source(lockstep.state(), in, lockstep.expected().outputs)) break;
    Compared<Design> actual;
    const bool same = lockstep.clock(in, [&](const auto&, const auto& rtl) { actual = rtl; });
    if (c <= clock && same != (c < clock)) refuse_unsteady(title);
    if (c == clock && lockstep.dut().said() != nullptr) {
      m.finding = lockstep.dut().said()->line_of_report();
    }
    if (c >= kept) m.stimulus.clocks.push_back(inputs.words(in));
    if (c < m.first || c > clock + window.after) continue;
    const Compared<Design>& expected = lockstep.expected();
    const auto& mask = lockstep.mask();
    std::size_t at = 0;
    detail::add_clock(m, at, inputs, in, in, [](std::size_t) { return true; });
    detail::add_clock(m, at, registers, expected.registers, actual.registers,
                      [&](std::size_t i) { return mask.of_cell(i); });
    detail::add_clock(m, at, outputs, expected.outputs, actual.outputs,
                      [&](std::size_t i) { return mask.of_cell(registers.fields().size() + i); });
  }
  return m;
}

/// Clocks `lockstep` from `source` until the source ends (true) or RTL and model differ (false),
/// and counts the clocks, the differing one included. `observe(source, compared)` is called after
/// each clock that matched.
template <class Adapter, class Source, class Observe>
bool clock_through(Lockstep<Adapter>& lockstep, Source& source, std::uint64_t& clocks,
                   Observe&& observe) {
  using Design = typename Adapter::Design;
  typename Design::template Inputs<Word> in;
  while (next_inputs<Design>(source, lockstep.dut().params, lockstep.state(), in,
                             lockstep.expected().outputs)) {
    ++clocks;
    if (!lockstep.clock(in)) return false;
    observe(source, lockstep.expected());
  }
  return true;
}

/// The same for long runs. Flattened: the model sees its parameters as constants, and a call on
/// each clock would have to save and restore too many registers.
template <class Adapter, class Source, class Observe>
COSIM_FLATTEN bool clock_fast(Lockstep<Adapter>& lockstep, Source& source, std::uint64_t& clocks,
                              Observe&& observe) {
  return clock_through(lockstep, source, clocks, observe);
}

}  // namespace cosim
