// Every figure that leaves the program is a finite number: JSON has no other, and no reader expects
// one.
#pragma once

#include <cmath>
#include <stdexcept>

namespace cosim {

/// The figure. std::logic_error where it is infinite or not a number, here and below.
inline double finite(double figure) {
  if (!std::isfinite(figure)) throw std::logic_error("a figure is not finite");
  return figure;
}

/// Of every figure in a JSON value; null is what JSON makes of one that is not finite.
template <class Json>
void check_finite(const Json& json) {
  if (json.is_null()) throw std::logic_error("a figure is not finite");
  if (json.is_number_float()) finite(json.template get<double>());
  if (!json.is_structured()) return;
  for (const Json& one : json) check_finite(one);
}

}  // namespace cosim
