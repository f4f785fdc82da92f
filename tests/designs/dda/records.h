// Records of the DDA's design by the names of their fields, and its shapes by their width.
#pragma once

#include "tb/designs/dda/design.h"
#include "tests/support/records.h"

namespace cosim::dda {

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
  Word rst = 0, write = 0, address = 0, data = 0, start = 0, stop = 0;
};
struct Shown {
  Word busy = 0, x_up = 0, x_down = 0, y_up = 0, y_down = 0, code_x = 0, code_y = 0;
};
/// The numbers of a state, or the codes of registers.
struct Held {
  Word running = 0, sequential = 0, normalise = 0, free = 0;
  Word sx = 0, sy = 0, rate_x = 0, rate_y = 0, x = 0, y = 0, left_x = 0, left_y = 0;
  Word two_a = 0, b = 0, two_c = 0;
};

constexpr Params of_width(int width) { return Design::shape_of({width}); }

}  // namespace cosim::dda
