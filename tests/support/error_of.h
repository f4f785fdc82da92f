// What is said of bad input.
#pragma once

#include <string>

#include "model/core/input_error.h"

namespace cosim::test {

/// The line of the InputError that `action` throws; "" where it throws none.
template <class Action>
std::string error_of(Action&& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace cosim::test
