// Questions on nets put to yosys-abc, the equivalence checker that comes with yosys.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "tb/proof/net_questions.h"
#include "tb/proof/solver.h"

namespace cosim::proof {

/// Has abc answer all that is asked, in `limit` seconds of processor time at the most. What it says
/// can be is tried on the nets; where it is not so, it has failed. It is stopped when `no_more`
/// becomes true.
Solved solve(const NetQuestions& questions, int limit, const std::atomic<bool>* no_more = nullptr);

/// Each bit that is asked as a netlist by itself, in the order of questions.asked: its inputs, and
/// the output `asked`.
std::vector<std::string> netlists(const NetQuestions& questions);

}  // namespace cosim::proof
