#include "model/linear/job.h"

#include <algorithm>

#include "model/linear/oracle.h"

namespace cosim::linear {

Task<Word> task_of(const Params& p, const Job& job) {
  return {job.line.major, low_bits(static_cast<Word>(job.line.code), p.m), job.words.has_value(),
          std::min(job.words.value_or(0), ones(p.n + 1))};
}

Checker<Word> checker_of(const Params& p, const Job& job) {
  return {ticks(p.gamma(), job.line.major), 0};
}

std::vector<Job> smaller(const Params& p, const Job& job) {
  std::vector<Job> jobs;
  const auto add = [&](auto change) {
    jobs.push_back(job);
    change(jobs.back());
  };
  for (int i = p.m - 1; i > 0; --i) {
    if (bit(job.line.major, i)) add([&](Job& j) { j.line.major &= ones(i); });
  }
  for (int i = p.m - 1; i >= 0; --i) {
    if (job.line.major >> i != 0) add([&](Job& j) { j.line.major -= Word{1} << i; });
  }
  for (int i = p.m - 1; i >= 0; --i) {
    if ((job.line.code >> i & 1) != 0) add([&](Job& j) { j.line.code ^= Code{1} << i; });
  }
  if (job.words) {
    if (*job.words > 0) add([](Job& j) { j.words = *j.words / 2; });
    if (*job.words > 0) add([](Job& j) { j.words = *j.words - 1; });
    add([](Job& j) { j.words.reset(); });
  }
  return jobs;
}

std::string describe(const Params& p, const Job& job) {
  std::string text = "BP = " + std::to_string(job.line.major) + ", UK = ";
  for (int i = p.m - 1; i >= 0; --i) text += (job.line.code >> i & 1) != 0 ? '1' : '0';
  if (job.words) text += ", given up after " + std::to_string(*job.words) + " words";
  return text;
}

}  // namespace cosim::linear
