// A proof that something never happens, found anew without the engines of reach.h and shown to a
// solver that is none of abc's.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "tb/nets/graph.h"

namespace cosim::proof {

/// An inductive invariant: it is so in the first state, it is so on a clock where it was on the
/// clock before, and where it is so `bad` is 0. CaDiCaL has said each of the three.
struct Invariant {
  bool is_checked = false;     ///< CaDiCaL has said so
  std::string missing;         ///< why it is not known
  std::size_t equalities = 0;  ///< of signals
  std::size_t clauses = 0;     ///< over registers, from abc's pdr
};

/// Looks for one. Ends when it is `until`.
Invariant invariant_of(const nets::Graph& graph, nets::Bit bad,
                       std::chrono::steady_clock::time_point until);

/// "checked by cadical: 28 equal signals and 9 clauses", or that it rests on abc alone, and why.
std::string to_text(const Invariant& invariant);

}  // namespace cosim::proof
