// What mutants are attacked with: the printed examples, hostile clocks, whole jobs at random, jobs
// with a pin that is nearly 0 or nearly full, long ones. A design says in
// tb/designs/NAME/mutation/jobs.h what its jobs are; hostile clocks need nothing.
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tb/mutation/mutants.h"
#include "tb/sim/replay.h"
#include "tb/sim/sweep.h"

namespace cosim::mutation {

/// The jobs of a design. Each function gives the jobs of one run.
template <class Design>
struct Jobs {
  using List = std::vector<typename HostOf<Design>::Job>;
  static List printed(const typename Design::Params&) { return {}; }
  static List random(const typename Design::Params&, std::uint64_t /*seed*/, std::uint64_t /*i*/) {
    return {};
  }
  static List longest(const typename Design::Params&, std::uint64_t /*seed*/, std::uint64_t /*i*/) {
    return {};
  }
};

inline constexpr std::uint64_t campaign_seed = 1;
inline constexpr std::uint64_t long_jobs = 16;
inline constexpr std::uint64_t quick_cases = 12;
inline constexpr std::uint64_t quick_disturbed = 200;
inline constexpr std::uint64_t thorough_cases = 3000;

/// Draws jobs on a new machine; the same jobs get the same power-up state.
template <class Design>
Case drawing(const Bench<Design>& bench, std::string name, typename Jobs<Design>::List jobs,
             std::uint64_t number) {
  const auto power_up = static_cast<std::uint32_t>(number);
  const auto run = [&bench, jobs, power_up] {
    Observers<Design> nobody{};
    return bench.open(power_up)->draw(jobs, nobody);
  };
  const auto before = [&bench, jobs, power_up](const Watch& watch) {
    bench.watch_drawn(jobs, power_up, watch);
  };
  return {std::move(name), run, before, power_up};
}

inline Case hostile(const AnyBench& bench, std::uint64_t i) {
  const HostileCase c{campaign_seed, i, 1000};
  return {fmt::format("hostile clocks, case {}", i), [&bench, c] { return bench.run_hostile(c); },
          [&bench, c](const Watch& watch) { bench.watch_hostile(c, watch); }, c.power_up()};
}

/// Jobs of a design that declares them.
inline Case declared(const AnyBench& bench, std::uint64_t i) {
  const auto power_up = static_cast<std::uint32_t>(i);
  return {fmt::format("random jobs {}", i),
          [&bench, i, power_up] {
            return bench.run_jobs(random_jobs(bench, campaign_seed, i), power_up).run;
          },
          [&bench, i, power_up](const Watch& watch) {
            bench.watch_jobs(random_jobs(bench, campaign_seed, i), power_up, watch);
          },
          power_up};
}

/// Words that are nearly 0 or nearly full: a single bit, and all but one, of a signed pin also
/// without its sign.
inline std::vector<Word> nearly(const Field& pin) {
  std::vector<Word> words;
  for (int bit = 0; bit < pin.width; ++bit) {
    const Word one = shift_left(1, bit);
    words.insert(words.end(), {one, one ^ ones(pin.width)});
    if (is_signed(pin) && bit < pin.width - 1) words.push_back(one ^ ones(pin.width - 1));
  }
  return words;
}

/// So many of a job's first clocks.
inline constexpr std::uint64_t disturbed_clocks = 64;

/// The first clocks of jobs with one wide pin held at such a word, each in its turn: a gate that
/// looks whether a word is 0 or full is told from one that looks at one bit less, and hostile
/// clocks seldom have a machine at work on it.
inline Stimulus disturbed(const AnyBench& bench, Stimulus s, std::uint64_t number) {
  if (s.clocks.size() > disturbed_clocks) s.clocks.resize(disturbed_clocks);
  std::vector<std::pair<std::size_t, Word>> turns;
  const std::vector<Field> pins = bench.inputs();
  for (std::size_t pin = 0; pin < pins.size(); ++pin) {
    if (pins[pin].width < 2) continue;
    for (const Word word : nearly(pins[pin])) turns.emplace_back(pin, word);
  }
  if (turns.empty()) return s;
  const auto [pin, word] = turns[number % turns.size()];
  for (auto& row : s.clocks) row[pin] = word;
  return s;
}

/// The same as cases number first .. last - 1; jobs_of(i) is the stimulus of the jobs of case i. Of
/// a design with rules for its inputs there is none.
template <class JobsOf>
void add_disturbed(std::vector<Case>& all, const AnyBench& bench, std::uint64_t first,
                   std::uint64_t last, JobsOf jobs_of) {
  if (!bench.assumed().empty()) return;
  for (std::uint64_t i = first; i < last; ++i) {
    const auto stimulus = [&bench, jobs_of, i] { return disturbed(bench, jobs_of(i), i); };
    all.push_back(
        {fmt::format("random job {}, disturbed", i),
         [&bench, stimulus] { return bench.replay(stimulus()); },
         [&bench, stimulus](const Watch& watch) { bench.watch_stimulus(stimulus(), watch); },
         static_cast<std::uint32_t>(i)});
  }
}
/// Of jobs that a design declares.
inline void add_disturbed(std::vector<Case>& all, const AnyBench& bench, std::uint64_t first,
                          std::uint64_t last) {
  if (bench.job_fields().empty()) return;
  add_disturbed(all, bench, first, last, [&bench](std::uint64_t i) {
    return bench.stimulus_of(random_jobs(bench, campaign_seed, i), static_cast<std::uint32_t>(i));
  });
}
/// Of random jobs that a design has for its mutants.
template <class Design>
void add_disturbed(std::vector<Case>& all, const Bench<Design>& bench, std::uint64_t first,
                   std::uint64_t last) {
  const auto jobs = [&bench](std::uint64_t i) {
    return Jobs<Design>::random(bench.params(), campaign_seed, i);
  };
  if (jobs(first).empty())
    return add_disturbed(all, static_cast<const AnyBench&>(bench), first, last);
  add_disturbed(all, bench, first, last, [&bench, jobs](std::uint64_t i) {
    return recorded<Design>(bench.params(), HostOf<Design>(bench.params(), jobs(i)),
                            static_cast<std::uint32_t>(i), disturbed_clocks);
  });
}

/// Cases of any bench, which must outlive them. In lockstep: hostile clocks and, where its design
/// declares jobs, random ones, by turns, and disturbed ones. Of streams: random transactions.
Cases cases_of(const AnyBench& bench);

/// Cases first .. last - 1 of hostile clocks and of random jobs, by turns.
template <class Design>
void add_cases(std::vector<Case>& all, const Bench<Design>& bench, std::uint64_t first,
               std::uint64_t last) {
  for (std::uint64_t i = first; i < last; ++i) {
    all.push_back(hostile(bench, i));
    auto jobs = Jobs<Design>::random(bench.params(), campaign_seed, i);
    if (!jobs.empty()) {
      all.push_back(drawing(bench, fmt::format("random job {}", i), std::move(jobs), i));
    }
    if (!bench.job_fields().empty()) all.push_back(declared(bench, i));
  }
}

/// Long jobs, cut after so many clocks.
template <class Design>
void add_longest(std::vector<Case>& all, const Bench<Design>& bench, const char* how_far,
                 std::uint64_t most_clocks) {
  for (std::uint64_t i = 0; i < long_jobs; ++i) {
    auto jobs = Jobs<Design>::longest(bench.params(), campaign_seed, i);
    if (jobs.empty()) return;
    all.push_back(drawing(bench, fmt::format("long job {}{}", i, how_far), std::move(jobs), i));
    all.back().most_clocks = most_clocks;
  }
}

/// All of them, on `bench`, which must outlive them.
template <class Design>
Cases cases_of(const Bench<Design>& bench) {
  Cases cases;
  auto printed = Jobs<Design>::printed(bench.params());
  if (!printed.empty()) {
    cases.all.push_back(drawing(bench, "printed example", std::move(printed), 0));
  }
  add_cases(cases.all, bench, 0, quick_cases);
  add_disturbed(cases.all, bench, 0, quick_disturbed);
  cases.quick = cases.all.size();
  add_longest(cases.all, bench, "", Case{}.most_clocks);
  add_cases(cases.all, bench, quick_cases, thorough_cases);
  add_disturbed(cases.all, bench, quick_disturbed, thorough_cases);
  add_longest(cases.all, bench, ", to its end", std::uint64_t{1} << 26);
  return cases;
}

}  // namespace cosim::mutation
