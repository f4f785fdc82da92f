// Arcs in lanes, see tb/nets/jobs.h.
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/circular/drive.h"
#include "model/circular/oracle.h"
#include "model/circular/walk.h"
#include "tb/nets/jobs.h"
#include "tb/sweep/path_check.h"

namespace cosim::circular {

struct LaneArcs {
  template <class V>
  using JobIn = nets::JobIn<LaneArcs, V>;
  using Design = circular::Design;
  using Job = Arc;
  template <class V>
  using Task = circular::Task<V>;
  template <class V>
  using Driven = circular::Driven<V>;
  template <class V>
  using Due = circular::Due<V>;
  template <class V>
  using Walked = circular::Walked<V>;

  static Task<Word> task_of(const Params& p, const Arc& arc) { return circular::task_of(p, arc); }
  static Due<Word> due_of(const Params& p, const Arc& arc) { return circular::due_of(p, arc); }
  static Walked<Word> begun(const Params& p, const Arc& arc) { return circular::begun(p, arc); }
  template <class V>
  static auto pins(const Params& p, const Task<V>& t, const Driven<V>& d) {
    return circular::pins(p, t, d);
  }
  template <class V>
  static auto turned(const Params& p, const Task<V>&, const Driven<V>& d, const Outputs<V>& seen) {
    return circular::turned(p, d, seen);
  }
  template <class V>
  static auto walked(const Params& p, const JobIn<V>& job, const Outputs<V>& seen,
                     Condition<V> over) {
    return circular::walked(p, job.due, job.walked, job.driven.steps, seen, over);
  }
  static constexpr std::size_t figures = Walked<Word>::index_least;

  class Figures {
   public:
    void add(const Params&, const Arc& arc, const Due<Word>& due, const Walked<Word>& at_end) {
      steps_ += static_cast<std::uint64_t>(due.steps);
      for (const Word excess : {at_end.least, at_end.most}) {
        max_deviation_ = std::max(max_deviation_, radial_deviation_by(excess, arc.radius2));
      }
    }
    Checked checked() const { return path_figures(steps_, max_deviation_); }

   private:
    std::uint64_t steps_ = 0;
    double max_deviation_ = 0;
  };
};

}  // namespace cosim::circular
