// What passes is as it was.
#pragma once

#include <cosim/stream.h>

#include "passing.h"

template <int FAULT>
struct Asserts : Passing {
  static constexpr auto in() { return stream<Passed>("x"); }
  static constexpr auto out() { return stream<Passed>("y").latency(1).steady(); }
};
