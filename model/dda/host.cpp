#include "model/dda/host.h"

#include <cstdlib>

namespace cosim::dda {
namespace {

using Start = State<Word>;

// The modes and every register behind them.
constexpr std::size_t addresses = Start::size - Start::index_sx + 1;

Word word_at(const Params& p, const Start& s, std::size_t address) {
  if (address == 0) return s.sequential + 2 * s.normalise + 4 * s.free;
  return to_words(registers(p, s))[Start::index_sx + address - 1];
}

}  // namespace

bool Host::next(Inputs<Word>& in, const Outputs<Word>& seen) {
  in = Design::rest();
  if (written_ == addresses) {
    // The start shows in `busy` one clock later.
    if (clocks_ == 0 || seen.busy) {
      const auto& clocks = jobs_[job_].clocks;
      in.stop = clocks && clocks_ >= *clocks;
      ++clocks_;
      return true;
    }
    written_ = 0;
    ++job_;
  }
  if (job_ == jobs_.size()) return false;
  in.write = 1;
  in.address = static_cast<Word>(written_);
  in.data = word_at(p_, jobs_[job_].start, written_);
  in.start = ++written_ == addresses;
  clocks_ = 0;
  return true;
}

std::vector<Job> Host::smaller(const Params& p, const Job& job) {
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

std::string Host::describe(const Params&, const Job& job) {
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
