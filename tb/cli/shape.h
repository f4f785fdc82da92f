// The options that name a design's shape, and the benches that have it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/core/input_error.h"
#include "tb/cli/command.h"
#include "tb/sim/bench.h"

namespace cosim::cli {

/// The parameters that the user fixed, by the RTL's names; all others are free.
using Shape = std::vector<Parameter>;

/// An option that fixes a parameter of a design.
struct ShapeOption {
  const char* parameter;  ///< its name in the RTL; the help shows it as the option's value
  const char* option;     ///< "--width"
  std::uint64_t low;      ///< the least value; the largest is 32
  const char* help;
};

/// The options of one design's shape. A command of several designs has one of these for each.
class ShapeOptions {
 public:
  static constexpr const char* smallest = "the smallest that holds it";

  explicit ShapeOptions(std::vector<ShapeOption> options)
      : options_(std::move(options)), typed_(options_.size()) {}

  /// Adds them. `otherwise`: the default, for the help of the first option.
  void add(const Command& command, const std::string& otherwise = smallest);
  /// InputError "--width: ..." for a value that is no number in range.
  Shape shape() const;

 private:
  std::vector<ShapeOption> options_;
  std::vector<Text> typed_;
};

/// All benches of the design that were built in that shape, ordered by their first parameter.
/// InputError if there is none.
std::vector<const AnyBench*> matching(const std::string& design, const Shape& shape);

template <class Design>
std::vector<const Bench<Design>*> matching(const Shape& shape) {
  std::vector<const Bench<Design>*> found;
  for (const AnyBench* bench : matching(Design::name, shape)) {
    found.push_back(&dynamic_cast<const Bench<Design>&>(*bench));
  }
  return found;
}

/// The first of these whose parameters fit. InputError with why(the last one) where none do.
template <class Design, class Fits, class Why>
const Bench<Design>& first_that(const Shape& shape, Fits fits, Why why) {
  const auto found = matching<Design>(shape);
  for (const auto* bench : found) {
    if (fits(bench->params())) return *bench;
  }
  throw InputError(why(*found.back()));
}

}  // namespace cosim::cli
