// Which of the faults planted in a copy of the models is there.
#pragma once

#include <cstdlib>
#include <type_traits>

namespace cosim {

/// $COSIM_FAULT; 0, no fault, where it is not set.
inline const int chosen_fault = [] {
  const char* number = std::getenv("COSIM_FAULT");
  return number == nullptr ? 0 : std::atoi(number);
}();

/// Whether fault `number` is there. A constant expression has none.
constexpr bool fault(int number) { return !std::is_constant_evaluated() && chosen_fault == number; }

}  // namespace cosim
