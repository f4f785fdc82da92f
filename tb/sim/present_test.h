// What a test by hand asks of its framework.
#pragma once

#include <string>

namespace cosim {

/// The test that runs at present, as its framework knows it.
struct PresentTest {
  std::string name;     ///< one line
  bool failed = false;  ///< something that it expected is not so
};
/// Asked when a Directed begins and when it ends. cosim_add_gtest() sets it.
inline PresentTest (*present_test)() = nullptr;

}  // namespace cosim
