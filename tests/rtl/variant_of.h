// A variant behind its adapter: what the sources made by CMake instantiate.
#pragma once

#include "tb/bench/design_bench.h"
#include "tb/dut/named_adapter.h"
#include "tests/rtl/variant.h"

namespace cosim::test {

template <class Adapter>
void add_variant(const char* name, const char* what) {
  using Bench = AdapterBench<Adapter>;
  const auto make = []() -> std::unique_ptr<AnyBench> { return std::make_unique<Bench>(); };
  variant_list<typename Adapter::Design>().push_back({name, what, std::make_unique<Bench>(), make});
}

}  // namespace cosim::test
