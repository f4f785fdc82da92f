// Claims put before the engines, several questions at a time. A claim is decided where two agree on
// each of its questions.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tb/proof/claims.h"

namespace cosim::proof {

enum class Engine {
  cec,   ///< yosys-abc, on the nets of a claim
  cvc5,  ///< on its scripts
  z3,    ///< on its scripts
};
std::string to_text(Engine engine);
/// The program that is run.
std::string program_of(Engine engine);
/// All of them, the quickest first.
std::vector<Engine> all_engines();
/// "cec, z3 and cvc5".
std::string listed(const std::vector<Engine>& engines);
/// Those that `list`, the value of --engines, names in its order: A,B,C. Throws InputError where it
/// names none, one twice, or one that is not among `all`.
std::vector<Engine> engines_of(const std::string& list,
                               const std::vector<Engine>& all = all_engines());
/// Whether there is something of the claim that the engine reads.
bool can_ask(Engine engine, const Claim& claim);

/// What one engine says of a claim.
struct Opinion {
  Engine engine = Engine::cec;
  /// By query, of nets one; Answer::stopped where it was not asked. Empty: nothing was.
  std::vector<Solved> solved{};
  double seconds() const;  ///< of processor time
};

struct Decision {
  std::vector<Opinion> opinions;
  /// As many engines as are needed answered each question as wanted, and none otherwise.
  bool proved = false;
  bool refuted = false;   ///< an engine gave an opposite answer, and none contradicts it
  bool disagree = false;  ///< the engines contradict each other
  std::string verdict;    ///< "proved", "REFUTED", or why it is neither
};

struct Asking {
  /// Asked in this order: two of them, and another where these do not answer soon, or nothing else
  /// is to be done. One alone decides by itself.
  std::vector<Engine> engines = all_engines();
  int limit = 300;    ///< seconds of processor time for one answer
  unsigned jobs = 1;  ///< questions at a time
  int slice = 6;  ///< seconds of the first try of a question; each later one has four times more
};

/// Told what came of a claim as soon as that is known, one at a time.
using Told = std::function<void(std::size_t claim, const Decision&)>;

/// Has the engines answer the claims. Results are in the order of the claims.
std::vector<Decision> decide(
    const std::vector<const Claim*>& claims, const Asking& asking,
    const Told& told = [](std::size_t, const Decision&) {});

/// Whether an engine reached its time limit, so that a longer one might help.
bool timed_out(const std::vector<Decision>& decisions);

/// Judges the opinions; `needed` engines must agree.
Decision judged(const Claim& claim, std::vector<Opinion> opinions, std::size_t needed = 2);

/// What the terms of a refuted claim are in a counterexample; empty where no engine has one.
std::map<std::string, std::string> refuting_values(const Claim& claim, const Decision& decision,
                                                   int limit);

}  // namespace cosim::proof
