// The benches as parameters of tests, named by their shapes.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tb/sim/bench.h"

namespace cosim::test {

/// "M8N5"
inline std::string shape_name(const AnyBench& bench) {
  std::string name;
  for (const Parameter& p : bench.parameters()) name += p.name + std::to_string(p.value);
  return name;
}

/// For INSTANTIATE_TEST_SUITE_P over benches of one design.
template <class BenchPointer>
std::string name_of_shape(const testing::TestParamInfo<BenchPointer>& info) {
  return shape_name(*info.param);
}

/// For INSTANTIATE_TEST_SUITE_P over all benches: "linearM8N5"
inline std::string name_of_bench(const testing::TestParamInfo<const AnyBench*>& info) {
  return info.param->design() + shape_name(*info.param);
}

inline std::vector<const AnyBench*> all_benches() {
  std::vector<const AnyBench*> all;
  for (const auto& bench : benches()) all.push_back(bench.get());
  return all;
}

/// The benches of a design whose parameters are as asked.
template <class Design, class Condition>
std::vector<const Bench<Design>*> benches_with(Condition condition) {
  std::vector<const Bench<Design>*> found;
  for (const Bench<Design>* bench : benches_of<Design>()) {
    if (condition(bench->params())) found.push_back(bench);
  }
  return found;
}

}  // namespace cosim::test
