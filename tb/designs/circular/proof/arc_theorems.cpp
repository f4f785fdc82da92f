// SU 1665343: from what the device outside puts on the pins to the first point, at every width that
// is shipped.
#include "tb/designs/circular/design.h"
#include "tb/designs/circular/proof/points.h"
#include "tb/designs/circular/proof/theorems.h"
#include "tb/nets/exported.h"

namespace cosim::circular {
namespace {

using namespace proof;

// A load with a start, from a machine at rest, of the source's F, CT7 and CT8 at a point that is
// nearest to the circle: the pins take the whole of F and codes of the counters.
nets::Truth arc_begins(const Widths& widths, FreeNumbers& free) {
  const int width = widths[0].value;
  const ArcPoint<nets::Number> at{free.number("X", width), free.number("Y", width),
                                  free.signed_number("D", width + 1)};
  const nets::Truth in_second = !(at.x > at.y);
  const nets::Number resting = select(in_second, at.y, at.x);
  // Nearest, as in circular_theorems.cpp; on X = 0 the arc is over.
  free.assume(at.x > nets::Number(0));
  free.assume((nets::Number(0) - resting < at.d) & !(at.d > resting));

  Numbers<nets::Number> begun = in_sector1(at);
  const Numbers<nets::Number> second = in_sector2(at);
  for (std::size_t i = 0; i < begun.size(); ++i) begun[i] = select(in_second, second[i], begun[i]);
  const auto& [t4, t16, f, ct7, ct8] = begun;
  const auto code = [&](const nets::Number& v) {
    return low_bits(to_ones_complement(v, width + 1), width + 1);
  };
  // rst, load, f, ct7, ct8, sector2, start and stop.
  const std::array<nets::Number, 8> pins{
      0, 1, low_bits(shift_right(f, 2), width + 2), code(ct7), code(ct8), t16, 1, 0};
  Design::Inputs<nets::Number> in;
  for_each_cell<decltype(in)>([&](auto cell, std::size_t i) { cell(in) = pins[i]; });

  const Params p = Design::shape_of({width});
  const auto step = Design::next(p, reset_state_of<Design, nets::Number>(p), in);
  nets::Truth right = true;
  for_each_cell<Design::Outputs<nets::Number>>([&](auto cell, std::size_t) {
    right = right & !is_set(cell(step.outputs));  // it does not run yet, and makes no step
  });
  for_each_cell<Design::State<nets::Number>>(
      [&](auto cell, std::size_t i) { right = right & (cell(step.state) == begun[i]); });
  return !right;
}

}  // namespace

std::vector<proof::Theorem> arc_theorems() {
  return {at_every_width(
      Design::name,
      "at every shipped width a load with a start puts a machine at rest at any point nearest to "
      "its circle, in the point's sector, without a step",
      arc_begins)};
}

}  // namespace cosim::circular
