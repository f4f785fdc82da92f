// Lockstep's verdict found in another way: the RTL is played through all the inputs by itself, the
// golden model likewise, and then the two records are laid side by side.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "tests/rtl/variant.h"

namespace cosim::test {

/// A test on one variant, whatever its design.
struct Subject {
  std::string name;
  std::function<void()> check;
  friend void PrintTo(const Subject& s, std::ostream* out) { *out << s.name; }
};
inline std::string name_of_subject(const testing::TestParamInfo<Subject>& info) {
  return info.param.name;
}

/// What a machine shows on one clock, before its edge.
template <class Design>
struct Shown {
  typename Design::template Registers<Word> registers;
  typename Design::template Outputs<Word> outputs;
};

template <class Design>
using Script = std::vector<typename Design::template Inputs<Word>>;
template <class Design>
using Record = std::vector<Shown<Design>>;

/// All that a host or a stimulus drives.
template <class Design, class Source>
Script<Design> script_of(Source source) {
  Script<Design> script;
  for (typename Design::template Inputs<Word> in; source.next(in, {});) script.push_back(in);
  return script;
}

/// The reset is not recorded.
template <class Design>
Record<Design> play(const Variant<Design>& variant, const Script<Design>& script,
                    std::uint32_t power_up = 1) {
  const auto machine = variant.bench->dut(power_up);
  machine->drive(Design::reset_inputs());
  machine->eval(false);
  machine->eval(true);
  Record<Design> record;
  for (const auto& in : script) {
    machine->drive(in);
    machine->eval(false);
    record.push_back({machine->registers(), machine->outputs()});
    machine->eval(true);
  }
  return record;
}

template <class Design>
Record<Design> predict(const typename Design::Params& p, const Script<Design>& script) {
  auto state = reset_state_of<Design, Word>(p);
  Record<Design> record;
  for (const auto& in : script) {
    const auto step = Design::next(p, state, in);
    record.push_back({Design::registers(p, state), step.outputs});
    state = step.state;
  }
  return record;
}

/// The first place where RTL and model part: the clock after the reset, from 0, and the first
/// signal of that clock, registers before outputs.
struct Difference {
  std::uint64_t clock = 0;
  std::string signal;
  Word expected = 0;
  Word actual = 0;

  friend bool operator==(const Difference&, const Difference&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Difference& d) {
    return out << "clock " << d.clock << ", " << d.signal << ": expected " << d.expected
               << ", actual " << d.actual;
  }
};

template <class Fields, class Record>
std::optional<Difference> difference_in(std::uint64_t clock, const Fields& fields,
                                        const Record& expected, const Record& actual) {
  const Words<Record> e = to_words(expected);
  const Words<Record> a = to_words(actual);
  for (std::size_t i = 0; i < Record::size; ++i) {
    if (e[i] != a[i]) return Difference{clock, fields[i].name, e[i], a[i]};
  }
  return {};
}

template <class Design>
std::optional<Difference> first_difference(const typename Design::Params& p,
                                           const Record<Design>& expected,
                                           const Record<Design>& actual) {
  const auto registers = Design::template Registers<Word>::fields(p);
  const auto outputs = Design::template Outputs<Word>::fields(p);
  for (std::size_t c = 0; c < expected.size(); ++c) {
    auto found = difference_in(c, registers, expected[c].registers, actual[c].registers);
    if (!found) found = difference_in(c, outputs, expected[c].outputs, actual[c].outputs);
    if (found) return found;
  }
  return {};
}

template <class Design>
std::optional<Difference> straight_run(const Variant<Design>& variant, const Script<Design>& script,
                                       std::uint32_t power_up = 1) {
  const auto p = variant.bench->params();
  return first_difference<Design>(p, predict<Design>(p, script), play(variant, script, power_up));
}

/// What lockstep reported.
inline std::optional<Difference> reported(const Run& run) {
  if (!run.mismatch) return {};
  return Difference{run.mismatch->clock, run.mismatch->signal, run.mismatch->expected,
                    run.mismatch->actual};
}

template <class Design>
Stimulus stimulus_of(const Script<Design>& script) {
  Stimulus stimulus;
  stimulus.power_up = 1;
  for (const auto& in : script) {
    const auto words = to_words(in);
    stimulus.clocks.emplace_back(words.begin(), words.end());
  }
  return stimulus;
}

/// Expects lockstep and the straight run to find `first` on these inputs, and lockstep to stop
/// there.
template <class Design>
void expect_found(const Variant<Design>& variant, const Script<Design>& script,
                  const Difference& first) {
  const Run run = variant.bench->replay(stimulus_of<Design>(script));
  EXPECT_EQ(reported(run), first) << variant.what;
  EXPECT_EQ(run.clocks, first.clock + 1) << variant.what;
  EXPECT_EQ(straight_run(variant, script), first) << variant.what;
}

/// Expects lockstep and the straight run to find nothing on any of these inputs.
template <class Design>
void expect_same(const Variant<Design>& variant, const Script<Design>& script) {
  const Run run = variant.bench->replay(stimulus_of<Design>(script));
  EXPECT_EQ(reported(run), std::nullopt) << variant.what;
  EXPECT_EQ(run.clocks, script.size()) << variant.what;
  EXPECT_EQ(straight_run(variant, script), std::nullopt) << variant.what;
}

}  // namespace cosim::test
