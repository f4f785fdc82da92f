// The benches of a shape: in lockstep where its model is a step, and of streams where it is a
// function of streams.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "tb/dut/named_adapter.h"
#include "tb/dut/open_dut.h"
#include "tb/dut/registers.h"
#include "tb/sim/design_bench.h"
#ifdef COSIM_STREAMS  // the model, which is read before, has read model/clocked/stream.h
#include "tb/stream/stream_bench.h"
#endif

namespace cosim {

/// Top: the Verilated class; open: that with its whole hierarchy open. Trait has Design, params,
/// title and clock, Model where it is a struct, and what the RTL's text says of its registers and
/// resets. InputError where that does not fit a model in lockstep.
template <class Top, class Trait>
std::vector<std::unique_ptr<AnyBench>> named_benches(const OpenClass& open) {
  using Design = typename Trait::Design;
  std::vector<std::unique_ptr<AnyBench>> all;
  if constexpr (StepsOn<Design, Word>) {
    using Adapter = NamedAdapter<Top, Trait>;
    auto bench = std::make_unique<DesignBench<Design>>(
        dut_maker<Adapter>(), open_maker<Design>(open, Trait::params), fast_loop<Adapter>);
    const auto patterns = Design::unobserved;
    bench->set_unobserved(
        require_registers<Design>({Trait::title, Trait::registers, Trait::resets, Trait::outputs},
                                  Trait::params),
        {patterns.begin(), patterns.end()});
    all.push_back(std::move(bench));
  }
#ifdef COSIM_STREAMS
  if constexpr (requires { requires clocked::HasStreams<typename Trait::Model>; }) {
    all.push_back(std::make_unique<StreamBench<Trait, VerilatedStreamDut<Top>>>(open));
  }
#endif
  return all;
}

/// Adds them to `all`. InputError where the model names another shape than Trait.
template <class Top, class Trait, const OpenLibrary& library>
void add_shape(std::vector<std::unique_ptr<AnyBench>>& all) {
  for (auto& bench : named_benches<Top, Trait>(open_class_in<Trait, library>())) {
    require_shape(*bench, Trait::title);
    all.push_back(std::move(bench));
  }
}

}  // namespace cosim
