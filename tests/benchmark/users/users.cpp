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
    using Job = JobOf<Trait_uartD16::Design>;
    return clocked::record_of<Job>(Uart<16>::Job{.idle = below(41), .byte = below(256)});
  });
  measure_loops<NamedAdapter<Vuart_rxD16, Trait_uart_rxD16>>("uart_rx", [] {
    Below below;
    InputList<NamedAdapter<Vuart_rxD16, Trait_uart_rxD16>> any{
        Trait_uart_rxD16::Design::reset_inputs()};
    using Model = UartRx<16>;
    using Inputs = Trait_uart_rxD16::Design::Inputs<Word>;
    while (any.size() < rows) {
      const Model::In in{.rst_n = below(64) != 0, .rx = below(2)};
      any.push_back(clocked::record_of<Inputs>(in));
    }
    return any;
  });
  return true;
}();

}  // namespace
}  // namespace cosim::bench
