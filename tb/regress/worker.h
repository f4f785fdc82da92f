// Runs shards of a run's folder, one after the other: what every process that works on it does.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/regress/run_folder.h"

namespace cosim::regress {

/// Numbers of shards as "1-3,7", for a command line; and from it. InputError "WHAT: ..." where the
/// text is no such list or one is not below `shards`.
std::string list_of(const std::vector<std::uint64_t>& shards);
std::vector<std::uint64_t> shards_in(const std::string& list, std::uint64_t shards,
                                     const std::string& what);

/// Runs these shards and appends what came of each to results/NAME.jsonl. A shard that cannot be
/// run leaves its reason there, and the next one is begun. Goes on from the checkpoints of shards
/// that were begun. 0 where all holds, 1 where something does not, 2 where a shard could not be
/// run. Interrupted when a signal comes, its checkpoint written.
int run_shards(const RunFolder& run, const Kinds& kinds, const std::vector<std::uint64_t>& shards,
               const std::string& name);

/// The name of this host, or of the node of a cluster that it is.
std::string host();

}  // namespace cosim::regress
