// Lines and conditions of a model of streams: run() is any C++, so the compiler's own counters
// (--coverage) see which of them a sweep reaches, and gcov reads them.
#pragma once

#include <string>

namespace cosim::coverage {

/// A program whose model GCC compiled with --coverage. Without `dump` nothing is counted.
struct Counted {
  void (*dump)() = nullptr;  ///< writes the counters: __gcov_dump
  std::string gcov;          ///< the program that reads them
  std::string notes;         ///< what the compiler wrote beside the object, .gcno
  std::string sources;       ///< the folder of the model: headers in it count
  std::string build;         ///< what CMake made, if within: does not count
};

/// Dumps the counters, and leaves two kinds of points (counts.h): each line of a function that ran,
/// by its text, and each `if` and `?:` that ran, with no hits if it went the same way each time. A
/// function that never ran has none: the line that calls it says so. InputError where gcov cannot
/// read them.
void leave_lines(const Counted& counted, const std::string& design);

}  // namespace cosim::coverage
