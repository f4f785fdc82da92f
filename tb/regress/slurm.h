// Shards on a cluster, by Slurm's own commands alone: sbatch, squeue, scontrol and scancel.
//
// The shards that are missing become job arrays, of which each task takes some of them, and a job
// that puts the report together behind them. What is submitted stands in the run's folder, in
// slurm/: for each array N.sh, the job, and N.txt, whose line I has the shards of task I; jobs.txt
// has the numbers of the jobs.
#pragma once

#include <string>
#include <vector>

#include "tb/regress/local.h"

namespace cosim::regress {

struct SlurmOptions {
  std::vector<std::string> sbatch;  ///< further options of sbatch, "--account=x"
  bool fail_fast = false;
  Tell tell;  ///< called now and then from the calling thread
};

/// Submits all shards that are missing, or takes up the jobs of this run that are still there, and
/// waits for them. Interrupted when a signal comes: then the jobs are cancelled. InputError where
/// sbatch refuses; then none is left.
Errors run_slurm(const RunFolder& run, const Kinds& kinds, const SlurmOptions& options);

/// What a task of an array does: its shards as far as they are missing. The status as of
/// run_shards(). Told to end while it runs, by a time limit or a preemption, it puts itself back
/// into the queue. InputError outside of an array.
int run_array_task(const RunFolder& run, const Kinds& kinds, const std::string& list);

}  // namespace cosim::regress
