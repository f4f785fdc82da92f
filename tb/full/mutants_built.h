// The program that attacks the mutants of one of the program's own machines.
#pragma once

#include <cstdint>
#include <string>

#include "tb/bench/bench.h"
#include "tb/program/registry.h"

namespace cosim::cli {

/// Has at most so many mutants planted in the machine's RTL and their program built; its path.
/// InputError where that fails.
std::string built_mutants(const Registry& registry, const AnyBench& bench, std::uint64_t mutants);

}  // namespace cosim::cli
