// Points of coverage: what Verilator and the cases and ways of a model have counted, read out of
// the files that counted runs left; and what came of those that no sweep reached, where an engine
// was asked for each whether it can ever happen.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tb/dut/counts.h"
#include "tb/sim/bench.h"

namespace cosim::coverage {

/// A place in the RTL, or a way through the model, at its last condition.
struct Point {
  /// line, branch, toggle, user; model way, branch, line, condition
  std::string kind;
  std::string file;
  int line = 0, column = 0;
  /// "count[3]" of a toggle, "if" or "else" of a branch; "false: if (x); after 36 true" of a way.
  std::string what;
  std::uint64_t hits = 0;
  /// The instances below the top, "a.b", or "*" in place of what differs between them.
  std::vector<std::string> instances = {};
};

/// Whether they are the same place, however often it was reached.
bool is_same(const Point& a, const Point& b);

inline bool is_of_model(const Point& p) { return p.kind.starts_with("model "); }
/// What a way or a branch of the model is called in its file (model/clocked/export.h).
std::string name_in_model(const Point& p);

struct Points {
  std::vector<Point> places;  ///< by file, line and column
  std::vector<Count> cases;   ///< in the order in which they were found
};

/// The sums over all files in the folder and below it: a place is the same in every instance and
/// shape. What a file before.* counted, of an instance up to the end of its reset, is no toggle: a
/// random power-up state toggles bits, but not by the stimuli. InputError where one cannot be read.
Points read_points(const std::string& folder);

enum class Answer {
  reached,      ///< by a sweep, or by a stimulus of the engine that was run in the counted RTL
  unreachable,  ///< proved in every shape
  open,         ///< neither in the time there was
  not_asked,    ///< a line, a bit that the RTL as nets does not have, or a point of a refused shape
};

/// Of the points of a design, in their order.
struct Answers {
  std::vector<Answer> places, cases;
  bool is_refused = false;  ///< nothing can be asked of a shape, and its line was printed
};

struct Asking {
  struct Shape {
    const AnyBench* bench = nullptr;
    Points points;  ///< those that it has
  };
  std::vector<Shape> shapes;  ///< of one design
  int seconds = 60;           ///< for each of them, at the most
  std::string stimuli;        ///< a folder: each that reaches a point is left in it
  /// Runs stimuli, by their files, in the counted RTL of a shape; then all points as they are now.
  std::function<Points(const AnyBench& bench, const std::vector<std::string>& files)> run;
};

}  // namespace cosim::coverage
