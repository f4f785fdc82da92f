#include "model/linear/host.h"

namespace cosim::linear {

bool Host::next(Inputs<Word>& in, const Outputs<Word>& seen) {
  in = Design::rest();
  if (phase_ == Phase::run) {
    words_ += seen.strobe;
    if (seen.busy) {
      const auto& words = jobs_[job_].words;
      in.initial_set_n = !(words && words_ >= *words);
      return true;
    }
    phase_ = Phase::bp;
    ++job_;
  }
  if (job_ == jobs_.size()) return false;
  const Line& line = jobs_[job_].line;
  switch (phase_) {
    case Phase::bp:
      in.write_bp = 1;
      in.data = line.major;
      words_ = 0;
      phase_ = Phase::uk;
      break;
    case Phase::uk:
      in.write_uk = 1;
      in.data = static_cast<Word>(line.code);
      phase_ = Phase::start;
      break;
    case Phase::start:
      in.start = 1;
      phase_ = Phase::rise;
      break;
    case Phase::rise:  // `busy` shows one clock after the start
    case Phase::run:
      phase_ = Phase::run;
      break;
  }
  return true;
}

std::vector<Job> Host::smaller(const Params& p, const Job& job) {
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

std::string Host::describe(const Params& p, const Job& job) {
  std::string text = "BP = " + std::to_string(job.line.major) + ", UK = ";
  for (int i = p.m - 1; i >= 0; --i) text += (job.line.code >> i & 1) != 0 ? '1' : '0';
  if (job.words) text += ", given up after " + std::to_string(*job.words) + " words";
  return text;
}

}  // namespace cosim::linear
