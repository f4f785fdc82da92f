#include "tests/studies/claims/line_table.h"

#include <fmt/format.h>

#include <cmath>

#include "tests/studies/claims/worst_line.h"

namespace cosim::claims {

namespace {

bool holds(bool yes, const char* what, int m) {
  if (!yes) fmt::print(stderr, "largest error of lines of {} bits: {}\n", m, what);
  return yes;
}

bool equal(double a, double b) { return std::abs(a - b) < 1e-6; }

}  // namespace

bool print_line_table() {
  bool good = true;
  for (const int m : {8, 10, 12}) {
    good &= holds(equal(worst_found(m).deviation, worst_of_all(m).deviation),
                  "the search misses the worst line", m);
  }
  fmt::print(
      "| lines of | up to | largest axial error, best code | of the line | "
      "at 100 steps/mm |\n| --- | --- | --- | --- | --- |\n");
  double before = 0;
  int bits_before = 0;
  for (const int m : {8, 12, 16, 20, 24, 32}) {
    const WorstLine line = worst_found(m);
    if (m <= 24) {
      good &= holds(equal(line.deviation, walked_deviation(m, line)), "the oracle differs", m);
    }
    // A bit adds a sixth where BP is 2^m, and less than twice that where it is not.
    const double growth = (line.deviation - before) / (m - bits_before);
    good &= holds(bits_before == 0 || (growth > 1 / 6.0 && growth < 1 / 3.0), "the growth", m);
    before = line.deviation;
    bits_before = m;
    fmt::print("| {} bits | {} steps | {:.2f} steps | {} by {} | {:.3f} mm |\n", m,
               (std::int64_t{1} << m) - 1, line.deviation, line.major,
               linear::minor_steps(m, line.major, line.code), line.deviation / 100);
  }
  return good;
}

}  // namespace cosim::claims
