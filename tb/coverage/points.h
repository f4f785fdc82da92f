// What Verilator and the cases of a model have counted, read out of the files that counted runs
// left.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/dut/counts.h"

namespace cosim::coverage {

/// A place in the RTL.
struct Point {
  std::string kind;  ///< line, branch, toggle, user
  std::string file;
  int line = 0, column = 0;
  std::string what;  ///< "count[3]" of a toggle, "if" or "else" of a branch
  std::uint64_t hits = 0;
  /// The instances below the top, "a.b", or "*" in place of what differs between them.
  std::vector<std::string> instances = {};
};

/// Whether they are the same place, however often it was reached.
bool is_same(const Point& a, const Point& b);

struct Points {
  std::vector<Point> rtl;    ///< by file, line and column
  std::vector<Count> cases;  ///< in the order in which they were found
};

/// The sums over all files in the folder and below it: a place is the same in every instance and
/// shape. What a file before.* counted, of an instance up to the end of its reset, is no toggle: a
/// random power-up state toggles bits, but not by the stimuli. InputError where one cannot be read.
Points read_points(const std::string& folder);

}  // namespace cosim::coverage
