// The queue of a Slurm cluster, by the commands that look at it and change it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cosim::regress {

/// Numbers of jobs, as sbatch prints them.
using Jobs = std::vector<std::string>;

/// Runs an sbatch with --parsable; the number of the job. InputError where it refuses.
std::string submitted(const std::vector<std::string>& words);

/// What is in the queue.
struct Queue {
  bool there = false;  ///< any of the jobs, or it cannot be asked at the moment
  std::uint64_t running = 0;
};
Queue in_queue(const Jobs& jobs);

/// Cancels those that are still there. Where that fails it says how to do it by hand.
void cancel(const Jobs& jobs);

/// Puts a job that is running back into the queue; not one that is being cancelled.
void put_back(const std::string& job);

/// Waits for some seconds. Interrupted when a signal comes.
void wait_a_moment();

}  // namespace cosim::regress
