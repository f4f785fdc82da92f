// RTL that is not as shipped, by name: made by tests/rtl/CMakeLists.txt from the files of
// tests/designs/*/rtl/variants.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tb/sim/bench.h"

namespace cosim::test {

template <class Design>
struct Variant {
  /// Its file under variants/<design>/, without the ending: "faults/outputs_swapped".
  std::string name;
  std::string what;  ///< what is different, in a sentence
  std::unique_ptr<const Bench<Design>> bench;
  /// Another one, for a list of benches.
  std::unique_ptr<AnyBench> (*make_bench)();
};

template <class Design>
using Variants = std::vector<Variant<Design>>;

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
    if (v.name == name) return v;
  }
  throw std::out_of_range("no variant " + std::string(name) + " of " + Design::name);
}

}  // namespace cosim::test
