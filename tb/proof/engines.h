// The engines that answer questions about gates.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "tb/proof/questions.h"

namespace cosim::proof {

enum class Engine {
  cec,      ///< yosys-abc, the equivalence checker that comes with yosys
  cadical,  ///< the SAT solver, which is a part of this program
};
std::string to_text(Engine engine);
/// All of them.
std::vector<Engine> all_engines();
/// "cec and cadical".
std::string listed(const std::vector<Engine>& engines);
/// Those that `list`, the value of --engines, names in its order: A,B. InputError where it names
/// none, one twice, or one that there is not.
std::vector<Engine> engines_of(const std::string& list);

/// Has an engine answer all that is asked, in `limit` seconds of processor time at the most. What
/// it says can be is tried on the gates; where it is not so, it has failed. It is stopped when
/// `no_more` becomes true, or the program is interrupted.
Solved solve(Engine engine, const Questions& questions, int limit,
             const std::atomic<bool>* no_more = nullptr);

}  // namespace cosim::proof
