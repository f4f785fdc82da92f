#include <fmt/core.h>
#include <fmt/format.h>

#include "model/core/input_error.h"
#include "tb/full_cli/prove.h"
#include "tb/proof/theorems.h"
#include "tb/support/words.h"
#include "tb/sweep/progress.h"

namespace cosim::cli {

// One line for each theorem, with its sentence.
int prove_theorems(const ProveOptions& o, const proof::Asking& asking) {
  std::vector<proof::Theorem> theorems;
  for (const proof::Theorem& t : proof::theorems()) {
    if (o.machine.empty() || o.machine.front() == t.design) theorems.push_back(t);
  }
  if (theorems.empty() || o.machine.size() > 1) {
    throw InputError(fmt::format("{}: is no design with theorems", fmt::join(o.machine, " ")));
  }
  std::vector<const proof::Claim*> claims;
  for (const auto& t : theorems) {
    if (o.scripts) keep_scripts(*o.scripts, t.design, t.claim);
    claims.push_back(&t.claim);
    claims.push_back(&t.premises);
  }
  const auto decisions = [&] {
    StateLine line;
    std::size_t known = 0;
    const auto say = [&] {
      line.show(fmt::format("{} of {} decided", known, count(claims.size(), "question")));
    };
    say();
    return proof::decide(claims, asking, [&](std::size_t, const proof::Decision&) {
      ++known;
      say();
    });
  }();
  std::size_t proved = 0;
  for (std::size_t i = 0; i < theorems.size(); ++i) {
    const proof::Decision &claim = decisions[2 * i], &premises = decisions[2 * i + 1];
    std::string times;
    for (const proof::Opinion& opinion : claim.opinions) {
      times += fmt::format("{} {:.2f} s, ", to_text(opinion.engine), opinion.seconds());
    }
    fmt::print("{}: {}.\n  {}{}\n", theorems[i].design, theorems[i].sentence, times, claim.verdict);
    if (!premises.proved) fmt::print("  its premises: {}\n", premises.verdict);
    std::fflush(stdout);
    proved += claim.proved && premises.proved ? 1 : 0;
  }
  fmt::print("{} of {} proved by {}\n", proved, count(theorems.size(), "theorem"),
             proof::listed(asking.engines));
  if (proof::timed_out(decisions)) say_limit(asking.limit);
  return proved == theorems.size() ? 0 : 1;
}

}  // namespace cosim::cli
