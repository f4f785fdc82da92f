#include "model/dda/job.h"

#include <algorithm>
#include <cstdlib>

namespace cosim::dda {
namespace {

using Start = State<Word>;

}  // namespace

Task<Word> task_of(const Params& p, const Job& job) {
  const Start& s = job.start;
  const auto words = to_words(registers(p, s));
  Task<Word> task;
  task.words[0] = s.sequential + 2 * s.normalise + 4 * s.free;
  for (int i = 1; i < addresses; ++i) {
    task.words[i] = words[Start::index_sx + static_cast<std::size_t>(i) - 1];
  }
  task.counted = job.clocks.has_value();
  task.clocks = job.clocks.value_or(0);
  return task;
}

int shifts_of(const Params& p, const Job& job) {
  const Word larger = std::max(std::abs(job.start.rate_x), std::abs(job.start.rate_y));
  int shifts = 0;
  if (job.start.normalise == 0 || larger == 0) return shifts;
  while ((larger << shifts) >> (p.width - 1) == 0) ++shifts;
  return shifts;
}

Checker<Word> checker_of(const Params& p, const Job& job) {
  const State<Word>& s = job.start;
  Checker<Word> w;
  w.shifts = shifts_of(p, job);
  w.left = job.clocks.value_or(0);
  w.sum_x = s.sx;
  w.sum_y = s.sy;
  w.rate_x = s.rate_x;
  w.rate_y = s.rate_y;
  w.x = s.x;
  w.y = s.y;
  w.left_x = s.left_x;
  w.left_y = s.left_y;
  return w;
}

std::vector<Job> smaller(const Params& p, const Job& job) {
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
  for (int i = p.width - 1; i >= 0; --i) {
    for (const Point less : {Point{s.rate_x & ~(Word{1} << i), s.rate_y},
                             Point{s.rate_x, s.rate_y & ~(Word{1} << i)}}) {
      if (less == Point{s.rate_x, s.rate_y} || s.rate_x < 0 || s.rate_y < 0) continue;
      Settings settings;
      settings.update = s.sequential ? Update::sequential : Update::parallel;
      settings.preload = s.sx == 0 ? Preload::zero : Preload::half;
      settings.normalise = s.normalise != 0;
      jobs.push_back(line(p, less, settings));
    }
  }
  return jobs;
}

std::string describe(const Params&, const Job& job) {
  const Start& s = job.start;
  const auto pair = [](Word a, Word b) {
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
