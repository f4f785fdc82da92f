// Lines in lanes, see tb/nets/jobs.h.
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/linear/host.h"
#include "model/linear/walk.h"
#include "tb/nets/jobs.h"
#include "tb/sweep/path_check.h"

namespace cosim::linear {

struct LaneLines {
  template <class V>
  using JobIn = nets::JobIn<LaneLines, V>;
  using Design = linear::Design;
  using Job = linear::Job;
  template <class V>
  using Task = linear::Task<V>;
  template <class V>
  using Driven = linear::Driven<V>;
  template <class V>
  using Due = linear::Due<V>;
  template <class V>
  using Walked = linear::Walked<V>;

  static Task<Word> task_of(const Params& p, const Job& job) { return linear::task_of(p, job); }
  static Due<Word> due_of(const Params& p, const Job& job) { return linear::due_of(p, job); }
  static Walked<Word> begun(const Params& p, const Job& job) { return linear::begun(p, job); }
  template <class V>
  static auto pins(const Params& p, const Task<V>& t, const Driven<V>& d) {
    return linear::pins(p, t, d);
  }
  template <class V>
  static auto turned(const Params& p, const Task<V>&, const Driven<V>& d, const Outputs<V>& seen) {
    return linear::turned(p, d, seen);
  }
  template <class V>
  static auto walked(const Params& p, const JobIn<V>& job, const Outputs<V>& seen,
                     Condition<V> over) {
    return linear::walked(p, job.task, job.due, job.walked, seen, over);
  }
  static constexpr std::size_t figures = Walked<Word>::index_words;

  // Every word was as it is due, so their number says what was drawn.
  class Figures {
   public:
    void add(const Params& p, const Job& job, const Due<Word>&, const Walked<Word>& at_end) {
      steps_ += static_cast<std::uint64_t>(std::min(job.line.major, at_end.words << p.gamma()));
      max_deviation_ =
          std::max(max_deviation_, max_deviation(p.m, job.line.major, job.line.code).value());
    }
    Checked checked() const { return path_figures(steps_, max_deviation_); }

   private:
    std::uint64_t steps_ = 0;
    double max_deviation_ = 0;
  };
};

}  // namespace cosim::linear
