// A device outside as step functions over a value type: on machine integers it drives the pins of
// one machine, on bits of gates those of as many as there are lanes. A design whose jobs it drives
// has in its namespace
//
//   Task<V>, Driven<V>                 records: what the device is told of a job, what it goes on
//                                      from: all 0 before a job and after its last clock
//   Task<Word> task_of(p, job)
//   Inputs<V> pins(p, task, driven)    of the next clock
//   Turn<Driven, V> turned(p, driven, outputs)
//
// None of them knows the clock.
#pragma once

#include <cstddef>
#include <span>

#include "model/core/value.h"

namespace cosim {

/// What the device goes on from after a clock, and whether that was the job's last one.
template <template <class> class Driven, class V>
struct Turn {
  Driven<V> driven;
  Condition<V> over;
};

/// Drives the machine's pins through a list of jobs, one after the other.
template <class Params, class JobType, template <class> class Inputs,
          template <class> class Outputs, template <class> class Task,
          template <class> class Driven>
class DrivingHost {
 public:
  using Job = JobType;

  /// `jobs` must outlive the host.
  DrivingHost(const Params& p, std::span<const Job> jobs) : p_(p), jobs_(jobs) {}

  /// The inputs of the next clock; false when the last job is over. `seen`: the outputs of the
  /// clock before (of no meaning on the first call).
  bool next(Inputs<Word>& in, const Outputs<Word>& seen) {
    bool begins = is_first_;
    if (!is_first_) {
      const auto turn = turned(p_, driven_, seen);
      driven_ = turn.driven;
      job_ += turn.over;
      begins = turn.over;
    }
    if (job_ == jobs_.size()) return false;
    if (begins) task_ = task_of(p_, jobs_[job_]);
    in = pins(p_, task_, driven_);
    is_first_ = false;
    return true;
  }

  /// The job that the last inputs belong to, from 0.
  std::size_t job() const { return job_; }

 private:
  Params p_;
  std::span<const Job> jobs_;
  std::size_t job_ = 0;
  bool is_first_ = true;
  Task<Word> task_;
  Driven<Word> driven_;
};

}  // namespace cosim
