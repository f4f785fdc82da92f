// What is proved, and what is kept of it.
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "model/core/input_error.h"
#include "tb/cli/chosen.h"
#include "tb/full/prove.h"
#include "tb/util/output_file.h"
#include "tb/util/words.h"

namespace cosim::cli {

namespace fs = std::filesystem;

std::vector<ProveSubject> subjects_of(const std::vector<std::string>& words) {
  std::vector<ProveSubject> all;
  std::set<std::string> refused;  // why, a line a design
  const std::string wanted = fmt::format("{}", fmt::join(words, " "));
  for (const auto& machine : proof::built_machines()) {
    if (!(machine.title + ' ').starts_with(wanted.empty() ? "" : wanted + ' ')) continue;
    const std::string design = machine.title.substr(0, machine.title.find(' '));
    if (!machine.is_provable()) {
      refused.insert(
          fmt::format("{}: {}: nothing can be proved of it", design, kind_of_model(machine)));
      continue;
    }
    all.push_back({machine.title, machine.nets(), machine.source});
  }
  if (all.empty() && !refused.empty()) throw InputError(*refused.begin());
  for (const std::string& line : refused) fmt::print("{}\n", line);
  if (words.empty()) {
    for (const Unusable& design : unusable()) {
      std::erase_if(all,
                    [&](const ProveSubject& s) { return s.model.machine.design == design.design; });
      leave_out(design.why);
    }
  }
  if (all.empty()) {
    throw InputError(
        fmt::format("{} is not built; see {} list", in_quotes(wanted), program_name()));
  }
  return all;
}

namespace {

std::string text_of_file(const std::string& folder, const std::string& name) {
  make_folder(folder);
  std::string plain = name;
  std::replace(plain.begin(), plain.end(), ' ', '_');
  std::replace(plain.begin(), plain.end(), '/', '_');
  std::erase(plain, '=');  // z3 takes what has one for an option
  return (fs::path(folder) / plain).string();
}

}  // namespace

void keep_questions(const std::string& folder, const std::string& title, const std::string& claim,
                    const proof::Questions& questions) {
  const auto texts = as_aiger(questions);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::string& what = questions.asked[i].name;
    OutputFile file(text_of_file(folder, fmt::format("{} {:.60} {}.aig", title, claim, what)));
    file.text(texts[i]);
    file.text(fmt::format("c\n{}: {}; {}\n", title, claim, what));
    file.close();
  }
}

void keep_questions(const std::string& folder, const proof::Theorem& theorem) {
  for (const proof::OnBits& one : theorem.on_bits) {
    keep_questions(folder, theorem.design, theorem.sentence, one.questions);
  }
  if (!theorem.on_integers) return;
  OutputFile file(
      text_of_file(folder, fmt::format("{} {:.60}.smt2", theorem.design, theorem.sentence)));
  file.line("; {}: {}", theorem.design, theorem.sentence);
  file.text(theorem.on_integers->negated);
  file.close();
}

}  // namespace cosim::cli
