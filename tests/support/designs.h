// The designs, for tests that are the same for each.
#pragma once

#include "model/circular/machine.h"
#include "model/dda/machine.h"
#include "model/linear/machine.h"

namespace cosim::test {

/// Calls visit.operator()<Design>() for every design.
template <class Visit>
void for_each_design(Visit visit) {
  visit.template operator()<linear::Design>();
  visit.template operator()<circular::Design>();
  visit.template operator()<dda::Design>();
}

}  // namespace cosim::test
