// The models of these tests, for the exporter and for the check of what it wrote.
#pragma once

#include <string>

#include "examples/uart/uart.h"
#if __has_include("model/circular/circular.h")  // a design that may be taken out
#include "model/circular/circular.h"
#define COSIM_WITH_CIRCULAR
#endif
#if __has_include("model/linear/linear.h")
#include "model/linear/linear.h"
#define COSIM_WITH_LINEAR
#endif
#include "tests/clocked/features.h"
#include "tests/clocked/rv32i.h"
#include "tests/clocked/turnstile.h"

namespace cosim::clocked::test {

/// Calls visit.operator()<Model>(name) for each.
template <class Visit>
void for_each_model(const Visit& visit) {
  visit.template operator()<Uart<4>>("uart_4");
  visit.template operator()<Uart<16>>("uart_16");
#ifdef COSIM_WITH_CIRCULAR
  visit.template operator()<Circular<8>>("circular_8");
  visit.template operator()<Circular<16>>("circular_16");
  visit.template operator()<Circular<32>>("circular_32");
#endif
#ifdef COSIM_WITH_LINEAR
  visit.template operator()<Linear<5, 2>>("linear_5_2");
  visit.template operator()<Linear<32, 26>>("linear_32_26");
#endif
  visit.template operator()<Rv32i>("rv32i");
  visit.template operator()<Features>("features");
  visit.template operator()<Turnstile>("turnstile");
  visit.template operator()<Valid<60>>("valid_60");
}

}  // namespace cosim::clocked::test
