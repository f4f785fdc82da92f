// Golden model of lfsr.v.
#pragma once

#include <string_view>

#include "model/core/design.h"

namespace lfsr_model {

using namespace cosim;

struct Params {
  int fault, taps;
  const char* mode;  ///< HOLD or FILL: what it does while it is not enabled
};

#define LFSR_INPUTS(FIELD) FIELD(en, 1, flag, "", "shift this clock")
#define LFSR_OUTPUTS(FIELD) FIELD(q, 8, bits, "", "the register")
#define LFSR_STATE(FIELD) FIELD(bits, 8, bits, "", "the register")
COSIM_RECORDS(LFSR, Params);

template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  V shifted = V(0);
  for (int i = 0; i < 8; ++i) {
    const auto below = i == 7 ? V(0) == V(1) : bit(s.bits, i + 1);
    const auto fed = bit(V(p.taps), i) & bit(s.bits, 0);
    shifted = shifted + select((below & !fed) | (fed & !below), V(1 << i), V(0));
  }
  const bool fills = std::string_view(p.mode) == "FILL";
  const V waiting = fills ? low_bits(shift_left(s.bits, 1) + V(1), 8) : s.bits;
  return {{select(is_set(in.en), shifted, waiting)}, {s.bits}};
}

struct Design {
  COSIM_DESIGN(lfsr_model);
  static constexpr const char* name = "lfsr";
  // Nothing clears it.
  template <class V>
  static constexpr State<V> reset_state() {
    return {V(0xa5)};
  }
  static constexpr std::array<Parameter, 3> parameters(const Params& p) {
    return {{{"FAULT", p.fault}, {"TAPS", p.taps}, {"MODE", p.mode}}};
  }
};

}  // namespace lfsr_model
