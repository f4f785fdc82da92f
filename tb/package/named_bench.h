// The benches of a shape whose nets are found by name: in lockstep where its model is a step, and
// of streams where it is a function of streams.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "tb/bench/design_bench.h"
#include "tb/dut/named_adapter.h"
#include "tb/dut/registers.h"
#include "tb/stream/stream_bench.h"

namespace cosim {

/// Top: the Verilated class. Trait has Design, params, title and clock, and what the RTL's text
/// says of its registers and resets. InputError where that does not fit a model in lockstep.
template <class Top, class Trait>
std::vector<std::unique_ptr<AnyBench>> named_benches() {
  using Design = typename Trait::Design;
  std::vector<std::unique_ptr<AnyBench>> all;
  if constexpr (!HasStreams<Design> || StepsOn<Design, Word>) {
    auto bench = std::make_unique<AdapterBench<NamedAdapter<Top, Trait>>>();
    bench->set_unobserved(
        require_registers<Design>({Trait::title, Trait::registers, Trait::resets}, Trait::params));
    all.push_back(std::move(bench));
  }
  if constexpr (HasStreams<Design>) all.push_back(std::make_unique<StreamBench<Top, Trait>>());
  return all;
}

}  // namespace cosim
