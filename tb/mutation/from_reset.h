// A mutant that no stimulus kills and that is not proved the same from every state: can it be told
// from the model from reset on? It is asked of proof/from_reset.h.
#pragma once

#include <chrono>
#include <filesystem>

#include "tb/mutation/subject.h"
#include "tb/proof/machines.h"

namespace cosim::mutation {

/// What the stimulus is called that kills such a mutant.
inline constexpr const char* from_reset_case = "a stimulus from reset";

/// Equivalent where it is proved; killed where a stimulus does it in a run, not only on the nets:
/// that is kept in the folder `root`, which is made. Else open. Takes `limit` at the most.
Outcome from_reset(const Subject& subject, const proof::BuiltMachine& machine, unsigned mutant,
                   std::chrono::seconds limit, const std::filesystem::path& root);

/// The file of that stimulus.
std::filesystem::path stimulus_of(const Subject& subject, unsigned mutant,
                                  const std::filesystem::path& root);

}  // namespace cosim::mutation
