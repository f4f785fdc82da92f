// An oracle as a step function over a value type, for as many jobs as there are lanes. A design
// with one has, beside what drives its jobs (drive.h),
//
//   Due<V>, Walked<V>                  records: what is due of a job, how far it is
//   Walk<V>                            a WalkOf these
//   Due<Word> due_of(p, job), Walked<Word> begun(p, job)
//   Verdict<Walked, V> walked(p, walk, outputs, over)
//
// of a clock with these outputs, the last one of its job where it is `over`. It does not know the
// clock.
#pragma once

#include "model/core/value.h"

namespace cosim {

/// A job on its way.
template <template <class> class Task, template <class> class Due, template <class> class Walked,
          template <class> class Driven, class V>
struct WalkOf {
  Task<V> task;
  Due<V> due;
  Walked<V> walked;
  Driven<V> driven;  ///< before this clock
};

template <template <class> class Walked, class V>
struct Verdict {
  Walked<V> walked;    ///< after the clock
  Condition<V> wrong;  ///< what the clock shows is not what is due
};

}  // namespace cosim
