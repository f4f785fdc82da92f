#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "model/core/input_error.h"
#include "tb/cli/chosen.h"
#include "tb/cli/number.h"
#include "tb/full/mutants_built.h"
#include "tb/full/prove.h"
#include "tb/proof/judge.h"
#include "tb/sim/progress.h"
#include "tb/util/words.h"

namespace cosim::cli {

namespace fs = std::filesystem;

namespace {

// Mutants in a file, each refuted or proved to be the same. The exit status.
int judged(const ProveSubject& subject, const fs::path& file, unsigned first, unsigned number,
           const proof::Asking& asking) {
  std::vector<unsigned> numbers(number);
  std::iota(numbers.begin(), numbers.end(), first);
  proof::Judge judge(subject.model, subject.source.top, asking);
  const auto judged = [&] {
    StateLine line;
    line.show(fmt::format("{}: {} asked", subject.title, count(number, "mutant")));
    return judge.judge(file, numbers);
  }();
  std::size_t refuted = 0, equal = 0;
  bool timed_out = false;
  for (unsigned k = 0; k < number; ++k) {
    refuted += judged[k].refuted ? 1 : 0;
    equal += judged[k].same ? 1 : 0;
    timed_out = timed_out || judged[k].timed_out;
    if (!judged[k].same && !judged[k].refuted) {
      fmt::print("mutant {}: {}\n", first + k, judged[k].verdict);
    }
  }
  fmt::print("{}: {}, {} refuted, {} proved to be the same, {} undecided\n", subject.title,
             count(number, "mutant"), refuted, equal, number - refuted - equal);
  if (number == 1 && refuted == 1) fmt::print("{}", judge.told_apart(file, first));
  if (timed_out) say_limit(asking.limit);
  return refuted + equal == number ? 0 : 1;
}

}  // namespace

int prove_mutants(const ProveOptions& o, const Registry& registry, const proof::Asking& asking) {
  const std::vector<ProveSubject> subjects = subjects_of(o.machine);
  if (o.mutants->find_first_not_of("0123456789") == std::string::npos) {
    if (o.mutant || o.count)
      throw InputError("--mutants: is a number, with no --mutant and --count");
    const std::uint64_t most = whole("--mutants", *o.mutants, 1, 65535);
    int status = 0;
    for (const ProveSubject& subject : subjects) {
      const AnyBench& bench = *chosen_shapes({subject.title}).front();
      const std::string program = built_mutants(registry, bench, most);
      const Scratch scratch;
      const fs::path file = scratch.path() / "mutants.v";
      run_mutants(program, {"--verilog", file});
      const auto number = static_cast<unsigned>(mutants_of(program).count);
      status = std::max(status, judged(subject, file, 1, number, asking));
    }
    return status;
  }
  if (subjects.size() != 1) throw InputError("--mutants: needs one machine");
  const fs::path file = *o.mutants;
  if (!fs::is_regular_file(file)) throw InputError(file.string() + ": no such file");
  if (o.mutant && o.count) throw InputError("--mutant: is one, with no --count");
  const auto pick = [](const char* option, const std::string& text) {
    return static_cast<unsigned>(whole(option, text, 1, 65535));
  };
  const unsigned first = o.mutant ? pick("--mutant", *o.mutant) : 1;
  const unsigned number = o.mutant ? 1 : pick("--count", o.count.value_or("100"));

  return judged(subjects.front(), file, first, number, asking);
}

}  // namespace cosim::cli
