// Runs a stimulus again, and makes one of what a host does.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/core/input_error.h"
#include "tb/run.h"
#include "tb/stimulus.h"

namespace cosim {

/// The clocks of a stimulus as a source of inputs. The stimulus must outlive it.
template <class Design>
class Rows {
 public:
  using Inputs = typename Design::template Inputs<Word>;

  explicit Rows(const Stimulus& stimulus) : left_(stimulus.clocks) {}

  bool next(Inputs& in, const typename Design::template Outputs<Word>&) {
    if (left_.empty()) return false;
    in = record_of<Inputs>(left_.front());
    left_ = left_.subspan(1);
    return true;
  }

  /// The record whose fields have the words given.
  template <class Record>
  static Record record_of(const std::vector<Word>& words) {
    Words<Record> array;
    std::copy_n(words.begin(), array.size(), array.begin());
    return from_words<Record>(array);
  }

 private:
  std::span<const std::vector<Word>> left_;
};

/// A machine where the stimulus starts. InputError where it starts from a state and the adapter
/// cannot load registers.
template <class Adapter>
std::unique_ptr<Lockstep<Adapter>> started(const Stimulus& s) {
  using Design = typename Adapter::Design;
  using State = typename Design::template State<Word>;
  if (!s.state) return std::make_unique<Lockstep<Adapter>>(s.power_up);
  if constexpr (requires(Adapter & a) { a.load("", Word{}); }) {
    return std::make_unique<Lockstep<Adapter>>(s.power_up,
                                               Rows<Design>::template record_of<State>(*s.state));
  } else {
    throw InputError(s.machine + " cannot start from a state");
  }
}

/// The first clock of the stimulus on which RTL and model differ.
template <class Adapter>
std::optional<std::uint64_t> differing_clock(const Stimulus& s) {
  const auto lockstep = started<Adapter>(s);
  Rows<typename Adapter::Design> rows(s);
  std::uint64_t clocks = 0;
  if (clock_through(*lockstep, rows, clocks, [](const auto&, const auto&) {})) return {};
  return clocks - 1;
}

/// What comes of the stimulus.
template <class Adapter>
Run replayed(const Stimulus& s, Window window) {
  Run result;
  result.clocks = s.clocks.size();
  if (const auto clock = differing_clock<Adapter>(s)) {
    result.clocks = *clock + 1;
    const auto again = started<Adapter>(s);
    result.mismatch = examine(*again, Rows<typename Adapter::Design>(s), *clock, window);
    result.mismatch->stimulus = s;
  }
  return result;
}

/// The inputs that `source` gives to a machine without a fault, as a stimulus of at most `clocks`
/// clocks: by the model alone.
template <class Design, class Source>
Stimulus recorded(const typename Design::Params& p, Source source, std::uint32_t power_up,
                  std::uint64_t clocks) {
  Stimulus stimulus;
  stimulus.power_up = power_up;
  auto state = Design::template cleared<Word>();
  typename Design::template Inputs<Word> in;
  typename Design::template Outputs<Word> out{};
  while (stimulus.clocks.size() < clocks && source.next(in, out)) {
    detail::add_inputs(stimulus, in);
    const auto step = Design::next(p, state, in);
    out = step.outputs;
    state = step.state;
  }
  return stimulus;
}

/// The smallest case found that fails as `jobs` do: fewer jobs, then smaller ones.
template <class Adapter>
SmallerCase smaller_case(std::vector<typename Adapter::Design::Host::Job> jobs,
                         std::uint32_t power_up) {
  using Design = typename Adapter::Design;
  using Host = typename Design::Host;
  using Job = typename Host::Job;
  constexpr std::uint64_t most_clocks = 20'000'000;  // a second or two
  std::uint64_t clocks = 0, spent = 0;
  const auto fails = [&](const std::vector<Job>& some) {
    if (spent > most_clocks) return false;
    Lockstep<Adapter> lockstep(power_up);
    Host host(Adapter::params, some);
    std::uint64_t run = 0;
    const bool failed = !clock_through(lockstep, host, run, [](const auto&, const auto&) {});
    spent += run;
    if (failed) clocks = run;
    return failed;
  };
  fails(jobs);
  // The last job is the one that failed; the others matter only where it fails not by itself.
  if (std::vector<Job> last{jobs.back()}; fails(last)) jobs = last;
  for (std::size_t i = jobs.size(); jobs.size() > 1 && i-- > 0;) {
    std::vector<Job> fewer = jobs;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (fails(fewer)) jobs = fewer;
  }
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      for (const Job& smaller : Host::smaller(Adapter::params, jobs[i])) {
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
    what += (what.empty() ? "" : "; ") + Host::describe(Adapter::params, job);
  }
  return {what, recorded<Design>(Adapter::params, Host(Adapter::params, jobs), power_up, clocks)};
}

}  // namespace cosim
