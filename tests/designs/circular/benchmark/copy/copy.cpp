#include "VcircularW16_ports.h"
#include "circular_shapes.h"
#include "drawn.h"

namespace cosim::circular {
namespace {

[[maybe_unused]] const bool measured = [] {
  bench::measure_jobs<NamedAdapter<VcircularW16, Trait_circularW16>>(
      "copy of circular", [](bench::Below& below) {
        const Word radius = below(3000) + 1;
        Arc arc;
        arc.radius2 = static_cast<std::uint64_t>(radius * radius);
        arc.from = {radius, 0};
        return arc;
      });
  return true;
}();

}  // namespace
}  // namespace cosim::circular
