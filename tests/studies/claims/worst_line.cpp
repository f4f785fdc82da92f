#include "tests/studies/claims/worst_line.h"

#include <algorithm>
#include <cmath>

#include "model/linear/oracle.h"

namespace cosim::claims {

namespace {

constexpr int head_bits = 5, tail_bits = 3;

// m bits: `ends` holds the head and the tail, `odd` shifts the 0101... between them.
std::uint64_t pattern(int m, std::uint64_t ends, bool odd) {
  const std::uint64_t all = (std::uint64_t{1} << m) - 1;
  const std::uint64_t middle = all >> (head_bits + tail_bits) << tail_bits;
  const std::uint64_t tail = ends & ((1U << tail_bits) - 1);
  const std::uint64_t head = ends >> tail_bits << (m - head_bits);
  return head | tail | (middle & (0x5555555555555555U << (odd ? 1 : 0)));
}

}  // namespace

WorstLine worst_of_all(int m) {
  WorstLine worst;
  for (std::int64_t major = 1; major >> m == 0; ++major) {
    for (std::int64_t minor = 0; minor <= major; ++minor) {
      const auto code = linear::best_code(m, major, minor);
      const double deviation = linear::max_deviation(m, major, code).value();
      if (deviation > worst.deviation) worst = {major, code, deviation};
    }
  }
  return worst;
}

double walked_deviation(int m, const WorstLine& line) {
  const auto slope = static_cast<double>(linear::minor_steps(m, line.major, line.code)) /
                     static_cast<double>(line.major);
  double worst = 0;
  double minor = 0;
  for (std::int64_t q = 1; q <= line.major; ++q) {
    minor += linear::minor_steps_at(m, line.code, q) ? 1 : 0;
    worst = std::max(worst, std::abs(minor - static_cast<double>(q) * slope));
  }
  return worst;
}

WorstLine worst_found(int m) {
  constexpr std::uint64_t ends = 1U << (head_bits + tail_bits);
  WorstLine worst;
  for (std::uint64_t b = ends / 2; b < ends; ++b) {  // the first bit of BP is 1
    for (std::uint64_t c = 0; c < ends; ++c) {
      for (const int odd : {0, 1, 2, 3}) {
        const auto major = static_cast<std::int64_t>(pattern(m, b, (odd & 1) != 0));
        const std::int64_t minor = linear::minor_steps(m, major, pattern(m, c, (odd & 2) != 0));
        const linear::Code code = linear::best_code(m, major, minor);
        const double deviation = linear::max_deviation(m, major, code).value();
        if (deviation > worst.deviation) worst = {major, code, deviation};
      }
    }
  }
  return worst;
}

}  // namespace cosim::claims
