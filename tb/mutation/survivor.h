// The folder that a surviving mutant leaves: one that no stimulus and no proof told from the RTL.
//
//   report.txt   what it is, what was tried, how to give it to the solvers
//   report.json  the same for a program
//   mutants.v    the RTL with its mutants; mutsel is the number
#pragma once

#include <filesystem>

#include "tb/mutation/subject.h"

namespace cosim::mutation {

/// Writes root/<design>-<parameters>-mutant-<number> and returns it. `prover`: how a person calls
/// what proves; `apart`: the
/// state that tells it from the RTL without it, where one is known. InputError where it cannot be
/// written.
std::filesystem::path leave_survivor(const Subject& subject, unsigned mutant,
                                     const std::string& prover, const std::string& apart,
                                     const std::filesystem::path& root);

}  // namespace cosim::mutation
