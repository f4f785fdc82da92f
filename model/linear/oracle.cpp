#include "model/linear/oracle.h"
#include "model/core/wide.h"

#include <bit>
#include <cmath>

namespace cosim::linear {

bool minor_steps_at(int m, Code code, std::int64_t q) {
  if (q < 1) return false;
  const int i = std::countr_zero(static_cast<std::uint64_t>(q)) + 1;
  return i <= m && m - i < 64 && (code >> (m - i) & 1) != 0;
}

Words words_at(int m, int gamma, const Line& line, std::int64_t tick) {
  if (tick < 0 || tick >= ticks(gamma, line.major)) return {};
  const int positions = 1 << gamma;
  const std::int64_t before = tick << gamma;  // < line.major
  Words words;
  for (int p = 1; p <= positions && p <= line.major - before; ++p) {
    const std::uint64_t bit = std::uint64_t{1} << (positions - p);
    words.major |= bit;
    if (minor_steps_at(m, line.code, before + p)) words.minor |= bit;
  }
  return words;
}

std::int64_t ticks(int gamma, std::int64_t major) {
  if (gamma < 0 || gamma > 6 || major < 0) return 0;
  const std::int64_t whole = major >> gamma;
  return whole + (whole << gamma != major ? 1 : 0);
}

double deviation(std::int64_t major, std::int64_t minor, std::int64_t x, std::int64_t y) {
  const double length = std::hypot(static_cast<double>(major), static_cast<double>(minor));
  if (length == 0) return 0;
  return std::fabs(static_cast<double>(Int128{major} * y - Int128{minor} * x)) / length;
}

}  // namespace cosim::linear
