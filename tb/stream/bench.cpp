#include "tb/stream/bench.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/bench/wanted.h"
#include "tb/stream/draw.h"
#include "tb/stream/record.h"

namespace cosim {

/// A case, what must come of it, and its runs.
struct AnyStreamBench::Ready {
  Ready(const AnyStreamBench& b, const Stimulus& s)
      : bench(b), power_up(s.power_up), given(stream_case(b.shape_, s)), broken(rule(b, given)) {
    for (const StreamCase::Side& side : given.in) in.push_back(side.given);
    if (broken == nullptr) expected = b.expected(in);
  }

  /// InputError where it breaks a rule.
  void refuse() const {
    if (broken == nullptr) return;
    throw InputError(fmt::format("{}: a transaction that is assumed never to come; the rule is: {}",
                                 bench.title(), broken));
  }
  StreamResult run(std::uint64_t budget, bool gather, StreamObserver* observer = nullptr) {
    const auto machine = bench.dut(power_up);
    return run_stream(bench.shape_, *machine, order(budget, gather, observer));
  }
  StreamOrder order(std::uint64_t budget, bool gather, StreamObserver* observer) {
    return {given, expected, bench.sizes(in), power_up, budget, gather, observer};
  }

  const AnyStreamBench& bench;
  std::uint32_t power_up;
  StreamCase given;
  const char* broken;  // the first rule that the case breaks; then it cannot be run
  std::vector<Sequence> in;
  std::vector<Sequence> expected;

 private:
  static const char* rule(const AnyStreamBench& b, const StreamCase& given) {
    for (std::size_t s = 0; s < given.in.size(); ++s) {
      const Sequence& all = given.in[s].given;
      for (std::size_t n = 0; n < all.size(); ++n) {
        if (const char* broken = b.broken_rule(s, all[n])) return broken;
      }
    }
    return nullptr;
  }
};

namespace {

constexpr std::uint64_t no_budget = ~std::uint64_t{0};

}  // namespace

std::vector<Field> AnyStreamBench::compared() const {
  std::vector<Field> all;
  for (const Interface& i : shape_.out) all.insert(all.end(), i.cells.begin(), i.cells.end());
  return all;
}

std::string AnyStreamBench::compared_text() const {
  std::string names;
  for (const Interface& i : shape_.out) names += (names.empty() ? "" : ", ") + i.name;
  return "values and order of all that comes out at " + names;
}

std::string AnyStreamBench::text_of(const HostileCase& c) const {
  return fmt::format("{} clocks of transactions, seed {}", c.clocks, c.seed);
}

std::vector<Word> AnyStreamBench::rest() const {
  return std::vector<Word>(shape_.columns().size(), 0);
}

// Of the cases that share the clocks of a hostile one.
Stimulus AnyStreamBench::drawn(const HostileCase& c, std::uint64_t number) const {
  return draw_stream_case(
      shape_, c.seed, c.index * c.clocks + number, c.clocks,
      [this](std::size_t s, std::span<const Word> words) { return !broken_rule(s, words); });
}

Run AnyStreamBench::run_hostile(const HostileCase& c) const {
  draw_if_wanted(*this, [&] { return drawn(c, 0); });
  Run run;
  // Every case has a clock at least.
  for (std::uint64_t number = 0; run.clocks < c.clocks; ++number) {
    const Stimulus stimulus = drawn(c, number);
    const StreamResult result = Ready(*this, stimulus).run(c.clocks - run.clocks, false);
    if (!result.finding) {
      run.clocks += result.clocks;
      continue;
    }
    Run failed = replay(stimulus, Window{});
    if (!failed.mismatch) refuse_unsteady(title());
    failed.clocks += run.clocks;
    return failed;
  }
  return run;
}

Run AnyStreamBench::replay(const Stimulus& stimulus, Window window) const {
  Ready ready(*this, stimulus);
  ready.refuse();
  const StreamResult first = ready.run(no_budget, true);
  Run run;
  run.clocks = first.clocks;
  if (!first.finding) return run;
  run.clocks = first.finding->clock + 1;
  TraceRecorder recorder(shape_, *first.finding, window);
  ready.run(no_budget, false, &recorder);
  Mismatch m = recorder.take();
  m.bench = this;
  m.finding = to_text(shape_, ready.order(no_budget, true, nullptr), first);
  m.stimulus = stimulus;
  run.mismatch = std::move(m);
  return run;
}

std::optional<std::uint64_t> AnyStreamBench::first_difference(const Stimulus& stimulus) const {
  Ready ready(*this, stimulus);
  if (ready.broken != nullptr || !ready.run(no_budget, false).finding) return {};
  // A row may matter as long as it is there, by the stall of what comes out last.
  return stimulus.clocks.size() - 1;
}

std::vector<std::vector<std::vector<Word>>> AnyStreamBench::without(
    const std::vector<std::vector<Word>>& rows, std::size_t n) const {
  if (n + 1 == rows.size()) return {};
  const auto later = [&](std::vector<std::vector<Word>>& changed, std::size_t column) {
    Word& stall = changed[n + 1][column];
    stall = std::min<Word>(stall + rows[n][column] + 1, (1 << stall_width) - 1);
  };
  // The next one goes in as late as it did, and what comes of it is taken as late, or at once.
  std::vector<std::vector<Word>> in = rows;
  std::size_t at = 0;
  for (const Interface& i : shape_.in) {
    later(in, at + 1);
    at += 2 + i.cells.size();
  }
  std::vector<std::vector<Word>> both = in;
  for (const Interface& i : shape_.out) {
    if (i.can_stall()) later(both, at++);
    if (!i.can_wait()) continue;
    both[n + 1][at] |= rows[n][at];
    ++at;
  }
  for (auto* changed : {&in, &both})
    changed->erase(changed->begin() + static_cast<std::ptrdiff_t>(n));
  return {in, both};
}

void AnyStreamBench::show(const Stimulus& stimulus, Window around, WaveSink& sink) const {
  Ready ready(*this, stimulus);
  ready.refuse();
  const StreamResult first = ready.run(no_budget, false);
  const auto machine = open_dut(stimulus.power_up);
  WaveRecorder recorder(shape_, title(), *machine, first, around, sink);
  run_stream(shape_, *machine, ready.order(no_budget, false, &recorder));
  recorder.end();
}

}  // namespace cosim
