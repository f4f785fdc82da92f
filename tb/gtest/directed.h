// Tests by hand: set these pins, expect those outputs, on these clocks. RTL and model run in
// lockstep meanwhile, so every register is compared on every clock, and a test that fails leaves a
// folder as any other failure does. Needs no test framework: what goes wrong is thrown as text.
//
//   TEST(Counter, Counts) {
//     Directed<counter::Design> bench("W=4");
//     bench.in.en = 1;
//     bench.clocks(5);
//     EXPECT_EQ(bench.clock().count, 5);
//   }
//
// cosim_add_gtest() builds such tests.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/core/design.h"
#include "tb/bench/by_hand.h"
#include "tb/bench/list.h"
#include "tb/gtest/present_test.h"
#include "tb/stimulus/stimulus.h"

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
  /// One clock more; `broken` is the rule that its inputs break, null where they break none.
  /// InputError where they do, and where a value is not one of its pin.
  void clock(const std::vector<Word>& inputs, const char* broken);
  std::uint64_t clocks() const { return stimulus_.clocks.size(); }
  /// Keeps the failure. Throws Differ.
  [[noreturn]] void differs();
  /// At the end: a test that failed without a difference leaves its stimulus and its wave.
  void finish() noexcept;

 private:
  void keep() const;

  const AnyBench& bench_;
  std::vector<Field> fields_;
  Stimulus stimulus_;
  std::string name_;
  int exceptions_ = std::uncaught_exceptions();
  bool kept_ = false;
};

/// The one of `design` at `shape`, "W=4"; where that is "", the only one. InputError where there is
/// none or there are several.
const AnyBench& directed_choice(const std::vector<const AnyBench*>& benches,
                                const std::string& design, const std::string& shape);

template <class Design>
class Directed {
 public:
  using Inputs = typename Design::template Inputs<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  using State = typename Design::template State<Word>;
  /// Sets pins before a clock; `last` are the outputs of the clock before.
  using Driver = std::function<void(Inputs& in, const Outputs& last)>;
  /// Looks at a clock.
  using Monitor = std::function<void(const Inputs& in, const Outputs& out)>;

  /// The design at a shape, such as "W=4", just cleared; "" where only one is built. Registers that
  /// no reset reaches hold values drawn from the seed power_up.
  explicit Directed(const std::string& shape = "", std::uint32_t power_up = 1)
      : Directed(chosen(shape), power_up) {}
  explicit Directed(const AnyBench& bench, std::uint32_t power_up = 1)
      : record_(bench, power_up),
        any_(record_.begin()),
        both_(dynamic_cast<ByHand<Design>&>(*any_)) {}
  ~Directed() { record_.finish(); }
  Directed(const Directed&) = delete;
  Directed& operator=(const Directed&) = delete;

  /// The input pins. Each keeps its value until it gets another one. At first all are at rest.
  Inputs in = rest_of<Design>();

  /// One clock; gives the outputs during it. Throws Differ where RTL and model differ, InputError
  /// for a value that does not fit its pin and for inputs that the design says never come.
  const Outputs& clock() {
    for (const Driver& drive : drivers_) drive(in, out());
    const auto words = to_words(in);
    record_.clock({words.begin(), words.end()}, both_.broken_rule(in));
    if (!both_.clock(in)) record_.differs();
    for (const Monitor& watch : monitors_) watch(in, out());
    return out();
  }
  /// So many clocks; gives the outputs of the last.
  const Outputs& clocks(std::uint64_t number) {
    while (number-- > 0) clock();
    return out();
  }
  /// Clocks until holds(outputs), at most `most` times. True if it held.
  template <class Holds>
  bool until(Holds holds, std::uint64_t most) {
    while (most-- > 0) {
      if (holds(clock())) return true;
    }
    return false;
  }

  /// The outputs of the last clock; all 0 before the first.
  const Outputs& out() const { return both_.out(); }
  /// The state before the next clock.
  const State& state() const { return both_.state(); }

  /// From now on calls `driver` before each clock, `monitor` after it; several of them in the order
  /// in which they were added.
  void add(Driver driver) { drivers_.push_back(std::move(driver)); }
  void watch(Monitor monitor) { monitors_.push_back(std::move(monitor)); }

 private:
  static const AnyBench& chosen(const std::string& shape) {
    std::vector<const AnyBench*> all;
    for (const auto& bench : benches()) all.push_back(bench.get());
    return directed_choice(all, Design::name, shape);
  }

  DirectedRecord record_;
  std::unique_ptr<AnyByHand> any_;
  ByHand<Design>& both_;
  std::vector<Driver> drivers_;
  std::vector<Monitor> monitors_;
};

}  // namespace cosim
