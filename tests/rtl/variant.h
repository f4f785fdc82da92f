// RTL that is not as shipped, by name: made by tests/rtl/CMakeLists.txt from the files of
// tests/rtl/variants.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tb/bench.h"

namespace cosim::test {

/// One instance of the RTL by itself, stepped by the test: no model beside it, nothing compared.
template <class Design>
class Machine {
 public:
  using Inputs = typename Design::template Inputs<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  using Registers = typename Design::template Registers<Word>;

  virtual ~Machine() = default;
  virtual void drive(const Inputs& in) = 0;
  /// Brings the clock pin to a level and settles everything behind it.
  virtual void eval(bool clk) = 0;
  virtual Outputs outputs() const = 0;
  virtual Registers registers() const = 0;
};

template <class Design>
class Variant {
 public:
  using Inputs = typename Design::template Inputs<Word>;

  Variant(std::string name, std::string what) : name_(std::move(name)), what_(std::move(what)) {}
  virtual ~Variant() = default;

  /// Its file under variants/<design>/, without the ending: "faults/outputs_swapped".
  const std::string& name() const { return name_; }
  /// What is different, in a sentence.
  const std::string& what() const { return what_; }

  virtual const Bench<Design>& bench() const = 0;
  virtual std::unique_ptr<AnyBench> make_bench() const = 0;
  /// Lockstep over the inputs given, one entry a clock, on a machine powered up from `power_up`.
  virtual Run run_inputs(std::span<const Inputs> inputs, std::uint32_t power_up) const = 0;
  /// A machine outside lockstep that powers up to the same random values.
  virtual std::unique_ptr<Machine<Design>> machine(std::uint32_t power_up) const = 0;

 private:
  std::string name_;
  std::string what_;
};

template <class Design>
using Variants = std::vector<std::unique_ptr<const Variant<Design>>>;

/// The list of one design, which add_variants() fills.
template <class Design>
Variants<Design>& variant_list() {
  static Variants<Design> list;
  return list;
}

/// Fills the lists of all designs, on the first call; made by CMake.
void add_variants();

/// The variants of one design, by name.
template <class Design>
const Variants<Design>& variants() {
  add_variants();
  return variant_list<Design>();
}

/// The variant of that name; throws where there is none.
template <class Design>
const Variant<Design>& variant(std::string_view name) {
  for (const auto& v : variants<Design>()) {
    if (v->name() == name) return *v;
  }
  throw std::out_of_range("no variant " + std::string(name) + " of the " + Design::name +
                          " interpolator");
}

}  // namespace cosim::test
