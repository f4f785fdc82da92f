// Records of the linear design by the names of their fields, and its shapes by their parameters.
#pragma once

#include "tb/designs/linear/design.h"
#include "tests/support/records.h"

namespace cosim::linear {

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
  Word initial_set_n = 1, reset = 0, write_bp = 0, write_uk = 0, start = 0, data = 0;
  constexpr operator Inputs<Word>() const { return record_of<Inputs<Word>>(*this); }  // NOLINT
};
struct Shown {
  Word busy = 0, strobe = 0, minor = 0, major = 0;
  friend bool operator==(const Shown&, const Shown&) = default;
};
struct Held {
  Word trigger30 = 0, trigger31 = 0, trigger32 = 0, counter4 = 0, register5 = 0, multiplier6 = 0,
       register3 = 0, register9 = 0, trigger10 = 0;
  friend bool operator==(const Held&, const Held&) = default;
};

constexpr Params of(int m, int n) { return Design::shape_of({m, n}); }

}  // namespace cosim::linear
