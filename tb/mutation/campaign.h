// A whole run over a subject's mutants.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "tb/mutation/subject.h"
#include "tb/sim/checkpoint.h"

namespace cosim::mutation {

/// For each of these mutants, whether it was proved equivalent.
using Prover = std::function<std::vector<bool>(const std::vector<unsigned>& mutants)>;

/// What an open mutant is, asked for so long at the most: killed, equivalent, or open.
using Asker = std::function<Outcome(unsigned mutant, std::chrono::seconds limit)>;

/// Mutants first, first + 1, ... of a subject.
struct Part {
  unsigned first = 1;
  unsigned count = ~0U;  ///< at most
};

struct Campaign {
  unsigned first = 1;             ///< mutsel of the first outcome
  std::vector<Outcome> outcomes;  ///< none open
  double seconds = 0;             ///< taken, those of a run that was killed included

  std::size_t count(Outcome::End end) const;
};

/// Attacks every mutant of the part with the quick stimuli, gives the survivors to the prover, and
/// asks `asker` of those that are not proved, attacks what it leaves with all other stimuli, and
/// asks it again, for longer; all on `threads` threads, >= 1. Continues from the checkpoint and
/// leaves it in place. InputError if the RTL without a mutant differs from the model.
Campaign run_campaign(const Subject& subject, const Prover& prover, const Asker& asker,
                      unsigned threads, Checkpoint& checkpoint, const Part& part = {});

/// What follows the name of the results in that of their checkpoint, whose `state` has `doing`, a
/// few words on what the campaign does now.
inline constexpr const char* kept_as = ".part";

/// The campaign as JSON text: an object with `design`, `parameters`, `mutants`, `killed`,
/// `equivalent`, `survived`, `unread`, `seconds`, and `outcomes`, an object for each mutant with
/// `mutant`, its number, `what` and `end`, and where it was killed `stimulus`, `clock` and
/// `signal`.
std::string to_json(const Subject& subject, const Campaign& campaign);

}  // namespace cosim::mutation
