// SU 1665343: from what the device outside puts on the pins to the first point, at every width that
// is shipped.
#include "tb/designs/circular/design.h"
#include "tb/designs/circular/proof/points.h"
#include "tb/designs/circular/proof/theorems.h"
#include "tb/proof/exported.h"
#include "tb/proof/widths.h"

namespace cosim::circular {
namespace {

using namespace proof;

// A load with a start, from a machine at rest, of the source's F, CT7 and CT8 at a point that is
// nearest to the circle: the pins take the whole of F and codes of the counters.
Asked arc_begins(const Widths& widths) {
  const int width = widths[0].value;
  Script script("QF_BV");
  const ArcPoint<BitVector> at{free_number(script, "X", width), free_number(script, "Y", width),
                               free_signed(script, "D", width + 1)};
  const Truth in_second = !(at.x > at.y);
  const BitVector resting = select(in_second, at.y, at.x);
  // Nearest, as in circular_theorems.cpp; on X = 0 the arc is over.
  script.assume((at.x > BitVector(0)).expression());
  script.assume(((BitVector(0) - resting < at.d) & !(at.d > resting)).expression());

  Numbers<BitVector> begun = in_sector1(at);
  const Numbers<BitVector> second = in_sector2(at);
  for (std::size_t i = 0; i < begun.size(); ++i) begun[i] = select(in_second, second[i], begun[i]);
  const auto& [t4, t16, f, ct7, ct8] = begun;
  const auto code = [&](const BitVector& v) {
    return low_bits(to_ones_complement(v, width + 1), width + 1);
  };
  // rst, load, f, ct7, ct8, sector2, start and stop.
  const std::array<BitVector, 8> pins{
      0, 1, low_bits(shift_right(f, 2), width + 2), code(ct7), code(ct8), t16, 1, 0};
  Design::Inputs<BitVector> in;
  for_each_cell<decltype(in)>([&](auto cell, std::size_t i) { cell(in) = pins[i]; });

  const Params p = Design::shape_of({width});
  const auto step = Design::next(p, reset_state_of<Design, BitVector>(p), in);
  Truth right = true;
  for_each_cell<Design::Outputs<BitVector>>([&](auto cell, std::size_t) {
    right = right & !is_set(cell(step.outputs));  // it does not run yet, and makes no step
  });
  for_each_cell<Design::State<BitVector>>(
      [&](auto cell, std::size_t i) { right = right & (cell(step.state) == begun[i]); });
  return {script, !right};
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
