// Benches of models alone, for the targets.
#pragma once

#include <memory>

#include "tests/support/model_adapter.h"

namespace cosim::fuzz {

template <class D, typename D::Params P>
std::unique_ptr<AnyBench> bench() {
  return std::make_unique<DesignBench<D>>(dut_maker<test::ModelAdapter<D, P>>());
}

}  // namespace cosim::fuzz
