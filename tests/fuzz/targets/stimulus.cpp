// A stimulus file: what is read comes back from its own text, and runs.
// Needs: linear, circular
#include "tb/sim/stimulus_text.h"

#include "tests/designs/circular/records.h"
#include "tests/designs/linear/records.h"
#include "tests/fuzz/expect.h"
#include "tests/fuzz/machines.h"

namespace cosim::fuzz {
namespace {

constexpr std::size_t most_clocks = 1000;  // of those run again

const std::vector<std::unique_ptr<AnyBench>>& machines() {
  static const auto list = [] {
    std::vector<std::unique_ptr<AnyBench>> all;
    all.push_back(bench<linear::Design, linear::of(5, 2)>());
    all.push_back(bench<linear::Design, linear::of(32, 26)>());
    all.push_back(bench<circular::Design, circular::of_width(4)>());
    all.push_back(bench<circular::Design, circular::of_width(32)>());
    return all;
  }();
  return list;
}

void check(const Replay& read, const std::string& name) {
  const Stimulus& s = read.stimulus;
  expect(!s.clocks.empty(), "a stimulus has a clock");
  if (s.clocks.size() > most_clocks) return;
  const auto [bench, again] = parse_stimulus(name, to_text(s, *read.bench), machines());
  expect(bench == read.bench, "it comes back for its machine");
  expect(again.origin == s.origin && again.power_up == s.power_up, "its head comes back");
  expect(again.state == s.state && again.clocks == s.clocks, "its clocks come back");
  if (!s.state) expect(!read.bench->first_difference(s), "the model is as the model");
}

}  // namespace

FUZZ_TARGET(stimulus) {
  const std::string name = "x.stim";
  Replay read;
  if (!accepted(name, [&] { read = parse_stimulus(name, text, machines()); })) return;
  check(read, name);
}

}  // namespace cosim::fuzz
