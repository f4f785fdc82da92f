#include "model/dda/job.h"

#include <algorithm>
#include <cstdlib>

namespace cosim::dda {
int shifts_of(int width, const Job& job) {
  const std::int64_t larger = std::max(std::abs(job.start.rate_x), std::abs(job.start.rate_y));
  int shifts = 0;
  if (!job.start.normalise || larger == 0) return shifts;
  while ((larger << shifts) >> (width - 1) == 0) ++shifts;
  return shifts;
}

std::vector<Job> smaller(const Job& job) {
  std::vector<Job> jobs;
  const Start& s = job.start;
  if (job.clocks) {
    for (const std::int64_t clocks : {*job.clocks / 2, *job.clocks - 1}) {
      if (clocks < 0 || clocks >= *job.clocks) continue;
      jobs.push_back(job);
      jobs.back().clocks = clocks;
    }
    return jobs;
  }
  // A line has no clocks: one with a bit less on an axis.
  if (s.rate_x < 0 || s.rate_y < 0) return jobs;
  for (int i = 31; i >= 0; --i) {
    const std::int64_t bit = std::int64_t{1} << i;
    for (const Point less : {Point{s.rate_x & ~bit, s.rate_y}, Point{s.rate_x, s.rate_y & ~bit}}) {
      if (less == Point{s.rate_x, s.rate_y}) continue;
      jobs.push_back(job);
      Start& line = jobs.back().start;
      line.rate_x = line.left_x = less.x;
      line.rate_y = line.left_y = less.y;
    }
  }
  return jobs;
}

std::string describe(const Job& job) {
  const Start& s = job.start;
  const auto pair = [](std::int64_t a, std::int64_t b) {
    return "(" + std::to_string(a) + ", " + std::to_string(b) + ")";
  };
  std::string text = "rates " + pair(s.rate_x, s.rate_y) + " from " + pair(s.x, s.y);
  if (s.two_a != 0 || s.b != 0 || s.two_c != 0) {
    text += ", 2 A = " + std::to_string(s.two_a) + ", B = " + std::to_string(s.b) +
            ", 2 C = " + std::to_string(s.two_c);
  }
  text += s.sequential ? ", sequential" : ", parallel";
  if (!s.free) text += ", " + pair(s.left_x, s.left_y) + " steps";
  if (job.clocks) text += ", at most " + std::to_string(*job.clocks) + " clocks";
  return text;
}

}  // namespace cosim::dda
