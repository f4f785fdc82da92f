// The program that attacks the mutants of one of the program's own machines.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/cli/registry.h"
#include "tb/sim/bench.h"
#include "tb/util/process.h"

namespace cosim::cli {

/// Builds what attacks mutants; the path of a program that does so with at most so many of this
/// machine. InputError where that fails.
std::string built_mutants(const Registry& registry, const AnyBench& bench, std::uint64_t mutants);

/// Runs it, or another such program, with these words. InputError where it cannot be run, or ends
/// with another status than 0, none survived, and 1, some did.
Ended run_mutants(const std::string& program, const std::vector<std::string>& words);

/// Of what its mutants are and how many there are.
struct Mutants {
  std::string of;
  std::uint64_t count = 0;
};
Mutants mutants_of(const std::string& program);

}  // namespace cosim::cli
