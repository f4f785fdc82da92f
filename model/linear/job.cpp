#include "model/linear/job.h"

namespace cosim::linear {

std::vector<Job> smaller(int m, const Job& job) {
  std::vector<Job> jobs;
  const auto add = [&](auto change) {
    jobs.push_back(job);
    change(jobs.back());
  };
  for (int i = m - 1; i > 0; --i) {
    const auto power = std::int64_t{1} << i;
    if ((job.line.major & power) != 0) add([&](Job& j) { j.line.major &= power - 1; });
  }
  for (int i = m - 1; i >= 0; --i) {
    if (job.line.major >> i != 0) add([&](Job& j) { j.line.major -= std::int64_t{1} << i; });
  }
  for (int i = m - 1; i >= 0; --i) {
    if ((job.line.code >> i & 1) != 0) add([&](Job& j) { j.line.code ^= Code{1} << i; });
  }
  if (job.words) {
    if (*job.words > 0) add([](Job& j) { j.words = *j.words / 2; });
    if (*job.words > 0) add([](Job& j) { j.words = *j.words - 1; });
    add([](Job& j) { j.words.reset(); });
  }
  return jobs;
}

std::string describe(int m, const Job& job) {
  std::string text = "BP = " + std::to_string(job.line.major) + ", UK = ";
  for (int i = m - 1; i >= 0; --i) text += (job.line.code >> i & 1) != 0 ? '1' : '0';
  if (job.words) text += ", given up after " + std::to_string(*job.words) + " words";
  return text;
}

}  // namespace cosim::linear
