// Whether an and-inverter graph can be made to give what is asked, by CaDiCaL.
#pragma once

#include <chrono>
#include <vector>

#include "tb/nets/graph.h"
#include "tb/proof/answer.h"

namespace cosim::proof {

struct Satisfied {
  Answer answer = Answer::unsat;  ///< sat, unsat or timed_out
  std::vector<bool> inputs;       ///< of sat
};

/// Whether inputs of `logic`, which has no latches, make all of `all` 1 and one of `any` too. Ends
/// when it is `until`, or the program is interrupted.
Satisfied satisfy(const nets::Graph& logic, const nets::Bits& all, const nets::Bits& any,
                  std::chrono::steady_clock::time_point until);

}  // namespace cosim::proof
