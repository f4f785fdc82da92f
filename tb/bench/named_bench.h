// The bench of a shape whose nets are found by name: of streams where its model is a function of
// streams, else in lockstep.
#pragma once

#include <memory>

#include "tb/bench/design_bench.h"
#include "tb/dut/named_adapter.h"
#include "tb/dut/registers.h"
#include "tb/stream/stream_bench.h"

namespace cosim {

/// A stream model: what stream.h says of struct Design.
template <class Design>
concept HasStreams = requires(const typename Design::Params& p) {
  Design::in(p);
  Design::out(p);
};

/// Top: the Verilated class. Trait has Design, params, title and clock, and what the RTL's text
/// says of its registers and resets. InputError where that does not fit a model in lockstep.
template <class Top, class Trait>
std::unique_ptr<AnyBench> named_bench() {
  if constexpr (HasStreams<typename Trait::Design>) {
    return std::make_unique<StreamBench<Top, Trait>>();
  } else {
    auto bench = std::make_unique<AdapterBench<NamedAdapter<Top, Trait>>>();
    bench->set_unobserved(require_registers<typename Trait::Design>(
        {Trait::title, Trait::registers, Trait::resets}, Trait::params));
    return bench;
  }
}

}  // namespace cosim
