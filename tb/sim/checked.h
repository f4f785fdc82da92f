// What a check found of what was drawn: a second opinion beside lockstep, on whole jobs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cosim {

/// A figure that a design's check takes of its jobs.
struct Measure {
  /// How the figures of several runs are combined.
  enum class Sum { total, largest };

  std::string name;  ///< its key in reports: "max_deviation"
  Sum sum = Sum::total;
  std::string title;  ///< before the value, for a person: "largest deviation"; may be empty
  std::string unit;   ///< behind it, a noun in the singular: "step"
  std::variant<std::uint64_t, double> value;
};

/// "27 steps", "largest deviation 0.369 steps"
std::string to_text(const Measure& measure);

/// What a check found of a run of jobs.
struct Checked {
  std::uint64_t jobs = 0;  ///< finished
  std::string error;       ///< empty, or one line: the first difference between machine and oracle
  std::vector<Measure> measures;  ///< each name once

  /// The measure of that name, which must be one.
  const Measure& measure(std::string_view name) const;
  /// Its value, which must be of that type.
  std::uint64_t count(std::string_view name) const;
  double number(std::string_view name) const;
};

/// Adds the findings of two runs; the first error stays. InputError where a measure of the same
/// name is combined in two ways.
void add(Checked& sum, const Checked& one);

}  // namespace cosim
