// What a person sees of one interface on a clock, after sample().
#pragma once

#include "tb/stream/run.h"
#include "tb/stream/sides.h"

namespace cosim {

InterfaceSeen seen_of(const Giver& g);
InterfaceSeen seen_of(const Taker& t);

}  // namespace cosim
