// A result in the form that CI services show as a test: XML as JUnit writes it.
#pragma once

#include <string>

namespace cosim {

struct JunitCase {
  enum class End { passed, failure, error };

  std::string suite, name;
  End end = End::passed;
  std::string type;  ///< of a failure or an error, a word
  std::string text;  ///< lines: the first is its message
  double seconds = 0;
};

/// One suite of the one case. What XML cannot hold becomes "?".
std::string junit_text(const JunitCase& one);

}  // namespace cosim
