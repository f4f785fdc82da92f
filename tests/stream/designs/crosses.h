// What passes from one clock to another is as it was, in its order.
#pragma once

#include <cosim/stream.h>

#include "passing.h"

template <int FAULT>
struct Crosses : Passing {
  static constexpr auto in() { return stream<Passed>("x").clock("fast"); }
  static constexpr auto out() { return stream<Passed>("y").clock("slow"); }
};
