// The one parameter of most designs that are tried as a package: FAULT, 0 as the RTL is meant, 1
// with a fault in it.
#pragma once

#include <array>

#include "model/core/design.h"

namespace faulty {

struct Params {
  int fault;
};

/// What struct Design of a model with these parameters is made of.
struct Design {
  using Params = faulty::Params;
  static constexpr std::array<cosim::Parameter, 1> parameters(const Params& p) {
    return {{{"FAULT", p.fault}}};
  }
};

}  // namespace faulty
