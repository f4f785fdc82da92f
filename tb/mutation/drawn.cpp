// The order is drawn (Fisher-Yates), then the first of it that lanes kill are taken.
#include "tb/mutation/drawn.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>

#include "tb/util/json.h"
#include "tb/util/json_at.h"
#include "tb/util/output_file.h"
#include "tb/util/parallel.h"
#include "tb/util/random.h"
#include "tb/util/read_file.h"

namespace cosim::mutation {

void draw(const Subject& subject, std::size_t count, const std::filesystem::path& folder) {
  std::vector<unsigned> numbers(subject.mutants().size());
  std::iota(numbers.begin(), numbers.end(), 1U);
  Random random(campaign_seed);
  for (std::size_t i = numbers.size(); i > 1; --i)
    std::swap(numbers[i - 1], numbers[random.below(i)]);
  // Some of them nothing kills.
  numbers.resize(std::min(numbers.size(), count + count / 4 + 10));

  std::mutex guard;
  std::map<unsigned, Outcome> killed;
  subject.attack(numbers, 0, subject.cases().quick, cores(), [&](unsigned mutant, Outcome outcome) {
    const std::lock_guard lock(guard);
    if (outcome.end == Outcome::End::killed) killed[mutant] = std::move(outcome);
  });
  std::erase_if(numbers, [&](unsigned k) { return !killed.contains(k); });
  numbers.resize(std::min(numbers.size(), count));
  std::sort(numbers.begin(), numbers.end());
  const auto not_reset = subject.not_reset(numbers);
  Json list = Json::array();
  for (const unsigned k : numbers) {
    const Outcome& o = killed[k];
    list.push_back({{"mutant", k},
                    {"what", subject.mutants()[k - 1]},
                    {"stimulus", o.stimulus},
                    {"clock", o.clock},
                    {"signal", o.signal},
                    {"cleared", !std::binary_search(not_reset.begin(), not_reset.end(), k)}});
  }
  std::filesystem::create_directories(folder);
  subject.write_verilog(numbers, folder / "mutants.v");
  write_file((folder / "drawn.json").string(), json_text(list, 1) + '\n');
}

int check_drawn(const VerilatedMutants& mutants, const std::filesystem::path& folder) {
  const std::string file = (folder / "drawn.json").string();
  const std::vector<JsonAt> list = JsonAt(file, read_file(file)).list();
  const auto& cases = mutants.cases().all;
  std::size_t same = 0, not_reset = 0;
  std::mutex guard;
  in_parallel(list.size(), cores(), [&](std::uint64_t i) {
    const JsonAt& drawn = list[i];
    const bool cleared = drawn.at("cleared").yes();
    const std::string stimulus = drawn.at("stimulus").text();
    const auto mutant = static_cast<unsigned>(drawn.at("mutant").whole(1, most_mutants));
    const std::uint64_t clock = drawn.at("clock").whole();
    const std::string signal = drawn.at("signal").text();
    const auto only = std::ranges::find(cases, stimulus, &Case::name);
    const auto first = static_cast<std::size_t>(only - cases.begin());
    const Outcome o = cleared && only != cases.end()
                          ? mutants.attack(mutant, first, first + 1)
                          : mutants.attack(mutant, 0, mutants.cases().quick);
    const bool killed = o.end == Outcome::End::killed;
    const bool as_drawn =
        killed && o.stimulus == stimulus && o.clock == clock && o.signal == signal;
    const std::lock_guard lock(guard);
    if (cleared && as_drawn) ++same;
    if (!cleared && killed) ++not_reset;
    if (cleared ? !as_drawn : !killed) {
      fmt::print(
          "mutant {}: {}: in lanes {}, clock {}, {}; in lockstep {}\n", mutant,
          drawn.at("what").text(), stimulus, clock, signal,
          killed ? fmt::format("{}, clock {}, {}", o.stimulus, o.clock, o.signal) : "not killed");
    }
    return true;
  });
  fmt::print(
      "{}: of {} mutants that lanes killed lockstep kills {} by the same case on the same clock at "
      "the same signal, and {} that a reset leaves as they powered up\n",
      mutants.bench().title(), list.size(), same, not_reset);
  return same + not_reset == list.size() && !list.empty() ? 0 : 1;
}

}  // namespace cosim::mutation
