// The loops of loops.h, of the designs of examples/uart.
#include "VuartD16_ports.h"
#include "Vuart_rxD16_ports.h"
#include "drawn.h"
#include "uart_rx_shapes.h"
#include "uart_shapes.h"

namespace cosim::bench {
namespace {

[[maybe_unused]] const bool measured = [] {
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
