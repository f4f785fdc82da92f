// Runs a stimulus again, and records what a host does as a stimulus.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/core/input_error.h"
#include "tb/sim/run.h"
#include "tb/sim/stimulus.h"

namespace cosim {

/// The clocks of a stimulus as a source of inputs. The stimulus must outlive it.
template <class Design>
class Rows {
 public:
  using Inputs = typename Design::template Inputs<Word>;

  Rows(const typename Design::Params& p, const Stimulus& stimulus)
      : cells_(p), left_(stimulus.clocks) {}

  bool next(Inputs& in, const typename Design::template Outputs<Word>&) {
    if (left_.empty()) return false;
    in = cells_.record(left_.front());
    left_ = left_.subspan(1);
    ++clock_;
    return true;
  }
  /// The same, but it ends at a clock that breaks a rule of the design in the model's state s.
  bool next_legal(const typename Design::Params& p, const typename Design::template State<Word>& s,
                  Inputs& in) {
    if (!next(in, {})) return false;
    illegal_ = {clock_ - 1, broken_rule<Design>(p, s, in)};
    return illegal_.rule == nullptr;
  }
  /// Whether it ended so.
  const IllegalClock& illegal() const { return illegal_; }

 private:
  Cells<Inputs> cells_;
  std::span<const std::vector<Word>> left_;
  std::uint64_t clock_ = 0;
  IllegalClock illegal_;
};

/// A machine at the start of the stimulus. InputError if the stimulus starts from a state and the
/// registers cannot be loaded.
template <class Design>
std::unique_ptr<AnyLockstep<Design>> started(const DutMaker<Design>& maker, const Stimulus& s) {
  using State = typename Design::template State<Word>;
  if (s.state && !maker.can_load) throw InputError(s.machine + " cannot start from a state");
  const typename AnyAdapter<Design>::PowerUp start{maker, s.power_up};
  if (!s.state) return std::make_unique<AnyLockstep<Design>>(start);
  return std::make_unique<AnyLockstep<Design>>(start, Cells<State>(maker.params).record(*s.state));
}

/// What came of a stimulus.
struct Ran {
  std::optional<std::uint64_t> differs;  ///< the first clock on which RTL and model differ
  IllegalClock illegal;                  ///< before that
  std::vector<std::uint64_t> left_out;   ///< as of a Run
};

template <class Design>
Ran ran(const DutMaker<Design>& maker, const Stimulus& s) {
  const auto lockstep = started(maker, s);
  Rows<Design> rows(maker.params, s);
  std::uint64_t clocks = 0;
  if (clock_through(*lockstep, rows, clocks, [](const auto&, const auto&) {})) {
    return {{}, rows.illegal(), lockstep->mask().left_out()};
  }
  return {clocks - 1, {}, lockstep->mask().left_out()};
}

/// The first clock of the stimulus on which RTL and model differ. InputError where a clock before
/// it breaks a rule of the design.
template <class Design>
std::optional<std::uint64_t> differing_clock(const DutMaker<Design>& maker, const Stimulus& s) {
  const Ran r = ran(maker, s);
  r.illegal.refuse(s.machine);
  return r.differs;
}

/// Runs the stimulus and describes the first difference.
template <class Design>
[[gnu::cold]] Run replayed(const DutMaker<Design>& maker, const Stimulus& s, Window window) {
  Run result;
  result.clocks = s.clocks.size();
  Ran came = ran(maker, s);
  came.illegal.refuse(s.machine);
  result.left_out = std::move(came.left_out);
  if (const auto clock = came.differs) {
    result.clocks = *clock + 1;
    const auto again = started(maker, s);
    result.mismatch =
        examine(*again, source_of<Design>(maker.params, Rows<Design>(maker.params, s)), *clock,
                window, s.machine);
    result.mismatch->stimulus = s;
  }
  return result;
}

namespace detail {

template <class Design>
[[gnu::cold]] Stimulus recorded(const typename Design::Params& p, const InputSource<Design>& source,
                                std::uint32_t power_up, std::uint64_t clocks) {
  Stimulus stimulus;
  stimulus.power_up = power_up;
  const Cells<typename Design::template Inputs<Word>> inputs(p);
  auto state = reset_state_of<Design, Word>(p);
  typename Design::template Inputs<Word> in;
  typename Design::template Outputs<Word> out{};
  const Synchronizers<Design> taking(p);
  while (stimulus.clocks.size() < clocks && source(state, in, out)) {
    stimulus.clocks.push_back(inputs.words(in));
    const auto step = clock_of<Design, Word>(p, state, in);
    out = step.outputs;
    copy_fields(state, taking.taken(p, state, in, step.state));
  }
  return stimulus;
}

}  // namespace detail

/// The inputs that `source` gives when it sees the model in place of the RTL, as a stimulus of at
/// most `clocks` clocks.
template <class Design, class Source>
Stimulus recorded(const typename Design::Params& p, const Source& source, std::uint32_t power_up,
                  std::uint64_t clocks) {
  return detail::recorded<Design>(p, source_of<Design>(p, source), power_up, clocks);
}

/// The smallest case found that fails as `jobs` do: fewer jobs, then smaller ones.
template <class Design>
[[gnu::cold]] SmallerCase smaller_case(const DutMaker<Design>& maker,
                                       std::vector<typename HostOf<Design>::Job> jobs,
                                       std::uint32_t power_up) {
  using Host = HostOf<Design>;
  using Job = typename Host::Job;
  constexpr std::uint64_t most_clocks = 20'000'000;  // a second or two
  std::uint64_t clocks = 0, spent = 0;
  const auto fails = [&](const std::vector<Job>& some) {
    if (spent > most_clocks) return false;
    AnyLockstep<Design> lockstep(typename AnyAdapter<Design>::PowerUp{maker, power_up});
    Host host(maker.params, some);
    std::uint64_t run = 0;
    const bool failed = !clock_through(lockstep, host, run, [](const auto&, const auto&) {});
    spent += run;
    if (failed) clocks = run;
    return failed;
  };
  fails(jobs);
  // The last job is the one that failed; the others matter only if it does not fail alone.
  if (std::vector<Job> last{jobs.back()}; fails(last)) jobs = last;
  for (std::size_t i = jobs.size(); jobs.size() > 1 && i-- > 0;) {
    std::vector<Job> fewer = jobs;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (fails(fewer)) jobs = fewer;
  }
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      for (const Job& smaller : Host::smaller(maker.params, jobs[i])) {
        std::vector<Job> changed = jobs;
        changed[i] = smaller;
        if (!fails(changed)) continue;
        jobs = changed;
        again = true;
        break;
      }
    }
  }
  std::string what;
  for (const Job& job : jobs) {
    what += (what.empty() ? "" : "; ") + Host::describe(maker.params, job);
  }
  return {what, recorded<Design>(maker.params, Host(maker.params, jobs), power_up, clocks)};
}

}  // namespace cosim
