#include <fmt/core.h>
#include <fmt/format.h>

#include <atomic>

#include "model/core/input_error.h"
#include "tb/full/prove.h"
#include "tb/proof/theorems.h"
#include "tb/sim/progress.h"
#include "tb/util/parallel.h"
#include "tb/util/words.h"

namespace cosim::cli {

// One line for each theorem, with its sentence.
int prove_theorems(const ProveOptions& o, int limit, unsigned jobs, Verdicts& verdicts) {
  std::vector<proof::Theorem> theorems;
  for (const proof::Theorem& t : proof::theorems()) {
    if (o.machine.empty() || o.machine.front() == t.design) theorems.push_back(t);
  }
  if (theorems.empty() || o.machine.size() > 1) {
    throw InputError(fmt::format("{}: is no design with theorems", fmt::join(o.machine, " ")));
  }
  if (o.keep) {
    for (const auto& t : theorems) keep_questions(*o.keep, t);
  }
  std::vector<proof::Judgement> all(theorems.size());
  {
    StateLine line;
    std::atomic<std::size_t> known = 0;
    line.show([&] {
      return fmt::format("{} of {} decided", known.load(), count(theorems.size(), "theorem"));
    });
    in_parallel(theorems.size(), jobs, [&](std::uint64_t i) {
      all[i] = proof::judged(theorems[i], limit);
      ++known;
      return true;
    });
  }
  std::size_t proved = 0;
  bool more_time_helps = false;
  for (std::size_t i = 0; i < theorems.size(); ++i) {
    fmt::print("{}: {}.\n  {} {:.2f} s, {}\n", theorems[i].design, theorems[i].sentence,
               theorems[i].engine(), all[i].seconds, all[i].verdict);
    verdicts.add({fmt::format("{}: {}", theorems[i].design, theorems[i].sentence),
                  all[i].proved ? ci::Verdict::End::passed : ci::Verdict::End::failure, "theorem",
                  all[i].verdict, all[i].seconds});
    proved += all[i].proved ? 1 : 0;
    more_time_helps = more_time_helps || all[i].timed_out;
  }
  fmt::print("{} of {} proved\n", proved, count(theorems.size(), "theorem"));
  if (more_time_helps) say_limit(limit);
  return proved == theorems.size() ? 0 : 1;
}

}  // namespace cosim::cli
