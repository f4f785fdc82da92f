// The loops of loops.h, of designs of a user's own: the two of examples/uart, and a copy of
// circular.
#include <random>

#include "VcircularW16_ports.h"
#include "VuartD16_ports.h"
#include "Vuart_rxD16_ports.h"
#include "circular_shapes.h"
#include "loops.h"
#include "tb/dut/named_adapter.h"
#include "uart_rx_shapes.h"
#include "uart_shapes.h"

namespace cosim::bench {
namespace {

// Drawn for the benchmark alone: below n.
struct Below {
  std::mt19937_64 bits{1};
  Word operator()(Word n) { return static_cast<Word>(bits() % static_cast<std::uint64_t>(n)); }
};

// What the host drives for jobs that `draw(below)` makes.
template <class Adapter, class Draw>
void measure_jobs(const std::string& name, Draw draw) {
  measure_loops<Adapter>(name, [draw] {
    Below below;
    std::vector<JobOf<typename Adapter::Design>> jobs;
    for (int i = 0; i < 1000; ++i) jobs.push_back(draw(below));
    return inputs_of<Adapter>(jobs);
  });
}

[[maybe_unused]] const bool measured = [] {
  measure_jobs<NamedAdapter<VcircularW16, Trait_circularW16>>("copy of circular", [](Below& below) {
    const Word radius = below(3000) + 1;
    circular::Arc arc;
    arc.radius2 = static_cast<std::uint64_t>(radius * radius);
    arc.from = {radius, 0};
    return arc;
  });
  measure_jobs<NamedAdapter<VuartD16, Trait_uartD16>>("uart", [](Below& below) {
    return JobOf<uart_model::Design>{below(41), below(256)};
  });
  measure_loops<NamedAdapter<Vuart_rxD16, Trait_uart_rxD16>>("uart_rx", [] {
    Below below;
    InputList<NamedAdapter<Vuart_rxD16, Trait_uart_rxD16>> any{
        uart_rx_model::Design::reset_inputs()};
    while (any.size() < rows) any.push_back({.rst_n = below(64) != 0, .rx = below(2)});
    return any;
  });
  return true;
}();

}  // namespace
}  // namespace cosim::bench
