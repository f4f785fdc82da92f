// Every figure that the program prints is a finite number: JSON has no others.
#pragma once

#include <cmath>
#include <stdexcept>

namespace cosim {

/// The figure. std::logic_error where it is infinite or not a number, here and below.
inline double finite(double figure) {
  if (!std::isfinite(figure)) throw std::logic_error("a figure is not finite");
  return figure;
}

/// Checks every figure in a JSON value, in which a figure that is not finite has become null.
template <class Value>
void check_finite(const Value& json) {
  if (json.is_null()) throw std::logic_error("a figure is not finite");
  if (json.is_number_float()) finite(json.template get<double>());
  if (!json.is_structured()) return;
  for (const Value& one : json) check_finite(one);
}

}  // namespace cosim
