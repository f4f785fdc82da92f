// Questions about logic put to a SAT solver.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "tb/proof/aig.h"
#include "tb/proof/solver.h"

namespace cosim::proof {

/// The program that is asked: cadical, or z3 where it is not installed; "" where neither is.
std::string sat_solver();

struct Satisfied {
  Answer answer = Answer::failed;  ///< sat, unsat, timed_out, missing or failed
  std::vector<bool> inputs;        ///< of sat
};

/// Whether inputs of `logic`, which has no latches, make all of `all` 1 and one of `any` too. Ends
/// when it is `until`.
Satisfied satisfy(const Aig& logic, const std::vector<Aig::Lit>& all,
                  const std::vector<Aig::Lit>& any, std::chrono::steady_clock::time_point until);

}  // namespace cosim::proof
