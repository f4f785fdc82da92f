// What passes is as it was, in its order.
#pragma once

#include <cosim/stream.h>

#include "passing.h"

template <int FAULT>
struct Keeps : Passing {
  static constexpr auto in() { return stream<Passed>("x"); }
  static constexpr auto out() { return stream<Passed>("y"); }
};
