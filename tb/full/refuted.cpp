#include "tb/full/refuted.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace cosim::cli {
namespace {

// A proof is checked for as long as it took, but no less and no more than so long.
constexpr std::chrono::steady_clock::duration check_least = std::chrono::seconds(2),
                                              check_most = std::chrono::seconds(10);

}  // namespace

std::optional<Refuted> refuted(const nets::Model& model, const AnyBench& bench,
                               const proof::Decision& decision) {
  auto found = proof::counterexample(model, proof::refuting_values(decision));
  if (!found) return std::nullopt;
  Stimulus stimulus = bench.clock_from(words(found->state), words(found->inputs));
  stimulus.origin = refuted_case;
  Run run = bench.replay(stimulus);
  return Refuted{std::move(*found), std::move(stimulus), std::move(run)};
}

FromResetAnswer asked_from_reset(const proof::FromReset& machine, proof::Happens what,
                                 const AnyBench& bench, std::chrono::seconds limit, unsigned jobs) {
  const auto began = std::chrono::steady_clock::now();
  proof::HappensFromReset found = machine.ask(what, began + limit, jobs);
  FromResetAnswer answer;
  answer.ever = found.reached.ever;
  if (answer.ever == proof::Ever::never) {
    answer.verdict = "proved from reset by " + found.reached.by;
    if (found.reached.engines == 0) return answer;
    const auto now = std::chrono::steady_clock::now();
    const auto checked =
        machine.check(what, now + std::clamp(now - began, check_least, check_most));
    answer.verdict += "; " + to_text(checked);
    answer.is_checked = checked.is_checked;
    return answer;
  }
  if (answer.ever == proof::Ever::open) {
    answer.verdict =
        fmt::format("UNDECIDED: from reset not in the first {} clocks", found.reached.clocks);
    return answer;
  }
  answer.verdict =
      fmt::format("REFUTED from reset: clock {}, by {}", found.clocks.size() - 1, found.reached.by);
  answer.what = std::move(found.what);
  answer.stimulus.machine = bench.title();
  answer.stimulus.origin = "counterexample of the proof, from reset";
  answer.stimulus.clocks = std::move(found.clocks);
  // What no reset reaches is as it powers up.
  constexpr std::uint32_t power_ups = 64;
  for (std::uint32_t seed = 1; seed <= power_ups && !answer.run.mismatch; ++seed) {
    answer.stimulus.power_up = seed;
    answer.run = bench.replay(answer.stimulus);
  }
  return answer;
}

}  // namespace cosim::cli
