// The names of what a question is about, the same in scripts and nets.
#pragma once

#include <cstddef>
#include <string>

#include "model/core/fields.h"

namespace cosim::proof {

/// "in.start", of an element "state.store.3"; of what both sides give, "model.count.after".
std::string term_of(const char* side, const Field& field);
/// Whether the model's next state keeps sentence i of the invariant.
std::string term_of_invariant(std::size_t i);

inline constexpr const char* kInitial = ".initial";
inline constexpr const char* kSeen = ".seen";
inline constexpr const char* kOutput = ".output";
inline constexpr const char* kAfter = ".after";

}  // namespace cosim::proof
