#include "model/dda/conic.h"

#include <cmath>
#include <string>

#include "model/core/input_error.h"
#include "model/core/wide.h"

namespace cosim::dda {
namespace {

// Every product of a checked conic and a point is below 2^126.

struct Coefficient {
  const char* name;
  std::int64_t value, largest;
};

[[noreturn]] void refuse(const std::string& why) { throw InputError("conic: " + why); }

bool is_degenerate(const Conic& q) {
  const Int128 a = q.a, b = q.b, c = q.c, d = q.d, e = q.e, f = q.f;
  return 4 * a * c * f + b * d * e - a * e * e - c * d * d - b * b * f == 0;
}

}  // namespace

void check(const Conic& q) {
  for (const Coefficient& one : {Coefficient{"A", q.a, largest_factor},
                                 {"B", q.b, largest_factor},
                                 {"C", q.c, largest_factor},
                                 {"D", q.d, largest_factor},
                                 {"E", q.e, largest_factor},
                                 {"F", q.f, largest_constant}}) {
    if (-one.largest <= one.value && one.value <= one.largest) continue;
    refuse(std::string(one.name) + " = " + std::to_string(one.value) + " is more than " +
           std::to_string(one.largest) + " in size");
  }
  if (is_degenerate(q)) refuse("it is degenerate: lines, a point or nothing");
}

Point rates_at(const Conic& q, Point at) {
  const Int128 a = q.a, b = q.b, c = q.c, x = at.x, y = at.y;
  const Int128 rate_x = -(b * x + 2 * c * y + q.e), rate_y = 2 * a * x + b * y + q.d;
  if (rate_x == 0 && rate_y == 0) refuse(text(at) + " is its centre, where nothing moves");
  const Int128 value = a * x * x + b * x * y + c * y * y + q.d * x + q.e * y + q.f;
  const auto slope = std::hypot(static_cast<long double>(rate_x), static_cast<long double>(rate_y));
  if (2 * std::fabs(static_cast<long double>(value)) > slope) {
    refuse("it does not pass " + text(at));
  }
  for (const Int128 rate : {rate_x, rate_y}) {
    if (rate >> 62 == 0 || -rate >> 62 == 0) continue;
    refuse("its rates overflow every machine at " + text(at));
  }
  return {static_cast<std::int64_t>(rate_x), static_cast<std::int64_t>(rate_y)};
}

std::optional<double> ellipse_root(const Conic& q) {
  const Int128 square = 4 * Int128{q.a} * q.c - Int128{q.b} * q.b;
  if (square <= 0) return {};
  return std::sqrt(static_cast<double>(square));
}

}  // namespace cosim::dda
