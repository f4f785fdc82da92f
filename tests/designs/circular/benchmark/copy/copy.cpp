#include "VcircularW16_ports.h"
#include "circular_shapes.h"
#include "drawn.h"

namespace cosim::bench {
namespace {

[[maybe_unused]] const bool measured = [] {
  measure_jobs<NamedAdapter<VcircularW16, Trait_circularW16>>("copy of circular", [](Below& below) {
    const Word radius = below(3000) + 1;
    circular::Arc arc;
    arc.radius2 = static_cast<std::uint64_t>(radius * radius);
    arc.from = {radius, 0};
    return arc;
  });
  return true;
}();

}  // namespace
}  // namespace cosim::bench
