// SU 1665343: from what the device outside puts on the pins to the first point, at every width that
// is shipped.
#include "tb/designs/circular/proof/points.h"
#include "tb/designs/circular/proof/theorems.h"
#include "tb/proof/widths.h"

namespace cosim::circular {
namespace {

using namespace proof;

// A load with a start, from a machine at rest, of the source's F, CT7 and CT8 at a point that is
// nearest to the circle: the pins take the whole of F and codes of the counters.
Asked arc_begins(const Widths& widths) {
  const Params p{static_cast<int>(widths[0].value)};
  Script script("QF_BV");
  const ArcPoint<BitVector> at{free_number(script, "X", p.width), free_number(script, "Y", p.width),
                               free_signed(script, "D", p.width + 1)};
  const Truth in_second = !(at.x > at.y);
  const BitVector resting = select(in_second, at.y, at.x);
  // Nearest, as in circular_theorems.cpp; on X = 0 the arc is over.
  script.assume((at.x > BitVector(0)).expression());
  script.assume(((BitVector(0) - resting < at.d) & !(at.d > resting)).expression());

  const State<BitVector> first = in_sector1(at), second = in_sector2(at);
  const auto of_sector = [&](auto member) {
    return select(in_second, second.*member, first.*member);
  };
  const auto code = [&](auto member) {
    return low_bits(to_ones_complement(of_sector(member), p.width + 1), p.width + 1);
  };
  Inputs<BitVector> pins;
  pins.load = pins.start = BitVector(1);
  pins.sector2 = of_sector(&State<BitVector>::t16);
  pins.f = low_bits(shift_right(of_sector(&State<BitVector>::f), 2), p.width + 2);
  pins.ct7 = code(&State<BitVector>::ct7);
  pins.ct8 = code(&State<BitVector>::ct8);

  const auto step = next(p, reset_state<BitVector>(), pins);
  Truth right = !(is_set(step.outputs.step_x) | is_set(step.outputs.step_y));
  for_each_member<State<BitVector>>(
      [&](auto member, std::size_t) { right = right & (step.state.*member == of_sector(member)); });
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
