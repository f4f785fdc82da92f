// Tests by hand: set these pins, expect those outputs, on these clocks. RTL and model run in
// lockstep meanwhile, so every register is compared on every clock, and a test that fails leaves a
// folder as any other failure does. Needs no test framework: what goes wrong is thrown as text.
//
//   TEST(Counter, Counts) {
//     Directed<Counter<4>> bench;
//     bench.in.en = 1;
//     bench.clocks(5);
//     EXPECT_EQ(bench.clock().count, 5);
//   }
//
// cosim_add_gtest() builds such tests.
#pragma once

#include <algorithm>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <typeindex>
#include <vector>

#include "model/clocked/design.h"
#include "model/core/design.h"
#include "tb/sim/by_hand.h"
#include "tb/sim/list.h"
#include "tb/sim/present_test.h"
#include "tb/sim/stimulus.h"

namespace cosim {

/// RTL and model gave different values. what() says which signal on which clock, shows the clocks
/// around it, and names the folder of the failure.
class Differ : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a Directed did: its clocks, and what becomes of them.
class DirectedRecord {
 public:
  DirectedRecord(const AnyBench& bench, std::uint32_t power_up);

  /// RTL and model. InputError of a bench that has no clocks.
  std::unique_ptr<AnyByHand> begin() const;
  /// Adds a clock; `broken` is the assumption that its inputs break, or null. InputError if there
  /// is one, and for a value that does not fit its pin.
  void clock(const std::vector<Word>& inputs, const char* broken);
  std::uint64_t clocks() const { return stimulus_.clocks.size(); }
  /// Keeps the failure. Throws Differ.
  [[noreturn]] void differs();
  /// At the end: a test that failed without a difference leaves its stimulus and its wave.
  void finish() noexcept;

 private:
  void keep() const;

  const AnyBench& bench_;
  Stimulus stimulus_;
  std::string name_;
  int exceptions_ = std::uncaught_exceptions();
  bool kept_ = false;
};

/// The bench whose golden model is that struct. InputError where there is none.
const AnyBench& directed_choice(const std::vector<const AnyBench*>& benches, std::type_index model);

/// All that were built.
inline std::vector<const AnyBench*> built_benches() {
  std::vector<const AnyBench*> all;
  for (const auto& bench : benches()) all.push_back(bench.get());
  return all;
}

/// The types of a test by hand, and RTL and model: of a struct that is a golden model, `Model`.
template <class Model>
struct HandOf {
  static_assert(
      requires { typename Model::In; },
      "a model of streams knows no clock to be set by hand: write its transactions as a stimulus, "
      "and run it with PROGRAM replay FILE.stim");
  using Inputs = typename Model::In;
  using Outputs = typename Model::Out;
  using State = Model;
  template <class T>
  using Record = clocked::ModelRecord<Word, clocked::RecordTable<T>>;

  AnyByHand& both;
  Outputs last = clocked::zero<Outputs>();
  Model model{};

  static const AnyBench& bench() { return directed_choice(built_benches(), typeid(Model)); }
  static Inputs rest() {
    auto record = clocked::record_of<Record<Inputs>>(clocked::resting<Model>(false));
    Record<Inputs>::Table::raise_clocks(record);
    return clocked::object_of<Inputs>(record);
  }
  static std::vector<Word> words(const Inputs& in) {
    const auto all = to_words(clocked::codes_of<Record<Inputs>>(in));
    return {all.begin(), all.end()};
  }
  const char* broken_rule(const Inputs& in) const { return both.broken_rule(words(in)); }
  bool clock(const Inputs& in) {
    const bool same = both.clock(words(in));
    last = object<Outputs>(both.outputs());
    model = object<Model>(both.state());
    return same;
  }
  const Outputs& out() const { return last; }
  const State& now() const { return model; }

 private:
  template <class T>
  static T object(const std::vector<Word>& words) {
    Words<Record<T>> all{};
    std::copy(words.begin(), words.end(), all.begin());
    return clocked::object_of<T>(from_words<Record<T>>(all));
  }
};
/// `Model`: the struct at its shape.
template <class Model>
class Directed {
  using Hand = HandOf<Model>;

 public:
  using Inputs = typename Hand::Inputs;
  using Outputs = typename Hand::Outputs;
  using State = typename Hand::State;
  /// Sets pins before a clock; `last` are the outputs of the clock before.
  using Driver = std::function<void(Inputs& in, const Outputs& last)>;
  /// Is called after a clock, with its inputs and outputs.
  using Monitor = std::function<void(const Inputs& in, const Outputs& out)>;

  /// Begins with a reset. Registers that no reset reaches hold values drawn from the seed power_up.
  explicit Directed(std::uint32_t power_up = 1) : Directed(Hand::bench(), power_up) {}
  explicit Directed(const AnyBench& bench, std::uint32_t power_up = 1)
      : record_(bench, power_up), any_(record_.begin()), both_{*any_} {}
  ~Directed() { record_.finish(); }
  Directed(const Directed&) = delete;
  Directed& operator=(const Directed&) = delete;

  /// The input pins. Each keeps its value until it gets another one. At first all are at rest.
  Inputs in = Hand::rest();

  /// One clock; returns the outputs before its edge. Throws Differ if RTL and model differ,
  /// InputError for a value that does not fit its pin and for inputs that break an assumption.
  const Outputs& clock() {
    for (const Driver& drive : drivers_) drive(in, out());
    record_.clock(Hand::words(in), both_.broken_rule(in));
    if (!both_.clock(in)) record_.differs();
    for (const Monitor& watch : monitors_) watch(in, out());
    return out();
  }
  /// `number` clocks; returns the outputs of the last one.
  const Outputs& clocks(std::uint64_t number) {
    while (number-- > 0) clock();
    return out();
  }
  /// Clocks until holds(outputs) is true, at most `most` of them. Returns whether it became true.
  template <class Holds>
  bool until(Holds holds, std::uint64_t most) {
    while (most-- > 0) {
      if (holds(clock())) return true;
    }
    return false;
  }

  /// The outputs of the last clock; all 0 before the first one.
  const Outputs& out() const { return both_.out(); }
  /// The registers of the model after the last clock.
  const State& state() const { return both_.now(); }

  /// From now on calls `driver` before each clock and `monitor` after it, several in the order in
  /// which they were added.
  void add(Driver driver) { drivers_.push_back(std::move(driver)); }
  void watch(Monitor monitor) { monitors_.push_back(std::move(monitor)); }

 private:
  DirectedRecord record_;
  std::unique_ptr<AnyByHand> any_;
  Hand both_;
  std::vector<Driver> drivers_;
  std::vector<Monitor> monitors_;
};

}  // namespace cosim
