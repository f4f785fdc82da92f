// A variant behind its bench: what the sources made by CMake instantiate.
#pragma once

#include "tb/dut/open_dut.h"
#include "tests/rtl/variant.h"

namespace cosim::test {

/// The shape with these parameters.
template <class Design, class... Numbers>
constexpr typename Design::Params params_of(Numbers... numbers) {
  if constexpr (requires { Design::shape_of({numbers...}); }) {
    return Design::shape_of({numbers...});
  } else {
    return {numbers...};
  }
}

/// Of each design; compiled once, in support/variant_bench.cpp.
template <class Design>
std::unique_ptr<Bench<Design>> bench_of(const OpenClass& variant, const typename Design::Params& p);

template <class Top, class Trait>
void add_variant(const char* name, const char* what, bool loads) {
  using Design = typename Trait::Design;
  static OpenClass of = open_class<Top, Trait>();
  of.loads = loads;
  const auto make = []() -> std::unique_ptr<AnyBench> {
    return bench_of<Design>(of, Trait::params);
  };
  variant_list<Design>().push_back({name, what, bench_of<Design>(of, Trait::params), make});
}

}  // namespace cosim::test
