#include "tb/mutation/survivor.h"

#include <fmt/core.h>

#include <map>

#include "tb/report/failure.h"
#include "tb/report/report.h"
#include "tb/support/draft.h"
#include "tb/support/json.h"
#include "tb/support/process.h"
#include "tb/support/read_file.h"

namespace cosim::mutation {
namespace {

// Thousands of cases by what they are called in front of their number, and how many there are.
std::map<std::string, std::size_t> kinds_of(const std::vector<Case>& cases) {
  std::map<std::string, std::size_t> kinds;
  for (const Case& c : cases) ++kinds[c.name.substr(0, c.name.find_last_not_of(" 0123456789") + 1)];
  return kinds;
}

}  // namespace

std::filesystem::path leave_survivor(const Subject& subject, unsigned mutant,
                                     const std::string& prover, const std::string& apart,
                                     const std::filesystem::path& root) {
  const std::string title = subject.bench().title();
  const std::string& what = subject.mutants()[mutant - 1];
  Draft draft(root, failure_name(subject.bench(), fmt::format("mutant {}", mutant)));
  const std::string prove = fmt::format("{} {} --mutants {} --mutant {}", prover, title,
                                        (draft.target() / "mutants.v").string(), mutant);

  Json json{{"verdict", "survived"}, {"design", subject.bench().design()}};
  json["parameters"] = parameters(subject.bench());
  json["mutant"] = mutant;
  json["what"] = what;
  json["prove"] = prove;
  std::string text = fmt::format(
      "{}: mutant {} survived: {}\nNo proof that it is the same machine, and RTL and model part on "
      "no clock of these runs\n",
      title, mutant, what);
  for (const auto& [kind, runs] : kinds_of(subject.cases().all)) {
    text += fmt::format("  {}: {}\n", kind, runs);
    json["stimuli"][kind] = runs;
  }
  if (!apart.empty()) {
    text += "They part " + apart +
            "If that state is never reached, let invariant() of the model say so.\n";
  }
  text += fmt::format("To have the solvers look for a state in which they part:\n  {}\n", prove);

  draft.write("report.txt", text);
  draft.write("report.json", json_text(json, 1) + '\n');
  const Scratch scratch;
  const auto verilog = scratch.path() / "mutants.v";
  subject.write_verilog({mutant}, verilog);
  draft.write("mutants.v", read_file(verilog.string()));
  draft.finish_replacing();
  return draft.target();
}

}  // namespace cosim::mutation
