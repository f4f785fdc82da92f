// Lines and circles in lanes, see tb/nets/jobs.h.
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/dda/equation.h"
#include "model/dda/host.h"
#include "model/dda/walk.h"
#include "tb/nets/jobs.h"
#include "tb/sweep/path_check.h"

namespace cosim::dda {

struct LaneCurves {
  template <class V>
  using JobIn = nets::JobIn<LaneCurves, V>;
  using Design = dda::Design;
  using Job = dda::Job;
  template <class V>
  using Task = dda::Task<V>;
  template <class V>
  using Driven = dda::Driven<V>;
  template <class V>
  using Due = dda::Due<V>;
  template <class V>
  using Walked = dda::Walked<V>;

  static Task<Word> task_of(const Params& p, const Job& job) { return dda::task_of(p, job); }
  static Due<Word> due_of(const Params& p, const Job& job) { return dda::due_of(p, job); }
  static Walked<Word> begun(const Params& p, const Job& job) { return dda::begun(p, job); }
  template <class V>
  static auto pins(const Params& p, const Task<V>& t, const Driven<V>& d) {
    return dda::pins(p, t, d);
  }
  template <class V>
  static auto turned(const Params& p, const Task<V>&, const Driven<V>& d, const Outputs<V>& seen) {
    return dda::turned(p, d, seen);
  }
  template <class V>
  static auto walked(const Params& p, const JobIn<V>& job, const Outputs<V>& seen,
                     Condition<V> over) {
    return dda::walked(p, job.task, job.walked, seen, over);
  }
  static constexpr std::size_t figures = Walked<Word>::index_steps;

  class Figures {
   public:
    void add(const Params&, const Job& job, const Due<Word>& due, const Walked<Word>& at_end) {
      steps_ += static_cast<std::uint64_t>(at_end.steps);
      const Word scale = Word{1} << due.shifts;
      for (const Word excess : {at_end.least, at_end.most}) {
        max_deviation_ = std::max(max_deviation_, deviation_by(job, excess / scale));
      }
    }
    Checked checked() const { return path_figures(steps_, max_deviation_); }

   private:
    std::uint64_t steps_ = 0;
    double max_deviation_ = 0;
  };
};

}  // namespace cosim::dda
