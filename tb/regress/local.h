// Runs shards on this host's cores, a process each.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "tb/regress/report.h"

namespace cosim::regress {

/// How far a run is.
struct Tally {
  std::uint64_t shards = 0, done = 0, running = 0, failed = 0, errors = 0;
  double minutes = 0, done_minutes = 0;  ///< thought to take, of all and of those done

  std::uint64_t waiting() const { return shards - done - running - errors; }
};
using Tell = std::function<void(const Tally&)>;

struct LocalOptions {
  unsigned jobs = 1;  ///< processes at a time
  bool fail_fast = false;
  Tell tell;  ///< called now and then from the calling thread
};

/// How far it is by its results.
Tally tally_of(const RunFolder& run, const Results& results);

/// Why shards could not be run, by their numbers; a line each.
using Errors = std::map<std::uint64_t, std::string>;

/// Runs all shards that are missing; after a failure none that it makes needless, with fail_fast
/// none at all. Interrupted when a signal comes: then no process is left.
Errors run_local(const RunFolder& run, const Kinds& kinds, const LocalOptions& options);

}  // namespace cosim::regress
