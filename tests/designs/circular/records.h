// Records of the circular design by the names of their fields, and its shapes by their width.
#pragma once

#include "tb/designs/circular/design.h"
#include "tests/support/records.h"

namespace cosim::circular {

using test::named, test::record_of;

template <class V>
using Inputs = Design::Inputs<V>;
template <class V>
using Outputs = Design::Outputs<V>;
template <class V>
using State = Design::State<V>;
template <class V>
using Registers = Design::Registers<V>;

struct Pins {
  Word rst = 0, load = 0, f = 0, ct7 = 0, ct8 = 0, sector2 = 0, start = 0, stop = 0;
};
struct Shown {
  Word running = 0, step_y = 0, step_x = 0;
  friend bool operator==(const Shown&, const Shown&) = default;
};
/// The numbers of a state, or the codes of registers.
struct Held {
  Word t4 = 0, t16 = 0, f = 0, ct7 = 0, ct8 = 0;
};

constexpr Params of_width(int width) { return Design::shape_of({width}); }

}  // namespace cosim::circular
