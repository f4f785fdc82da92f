// What is proved, and what is kept of it.
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "model/core/input_error.h"
#include "tb/full_cli/prove.h"
#include "tb/program/chosen.h"
#include "tb/proof/abc.h"
#include "tb/support/output_file.h"
#include "tb/support/words.h"

namespace cosim::cli {

namespace fs = std::filesystem;

std::vector<ProveSubject> subjects_of(const std::vector<std::string>& words) {
  std::vector<ProveSubject> all;
  std::set<std::string> refused;  // why, a line a design
  const std::string wanted = fmt::format("{}", fmt::join(words, " "));
  for (const auto& machine : proof::built_machines()) {
    if (!(machine.title + ' ').starts_with(wanted.empty() ? "" : wanted + ' ')) continue;
    const std::string design = machine.title.substr(0, machine.title.find(' '));
    if (machine.formula == nullptr) {
      refused.insert(fmt::format("{}: {}: nothing can be proved of it", design,
                                 model_without_formula(machine)));
      continue;
    }
    proof::MachineFormula formula = machine.formula();
    all.push_back({machine.title, std::move(formula), machine.nets(), machine.source});
  }
  if (all.empty() && !refused.empty()) throw InputError(*refused.begin());
  for (const std::string& line : refused) fmt::print("{}\n", line);
  if (words.empty()) {
    for (const Unusable& design : unusable()) {
      std::erase_if(all, [&](const ProveSubject& s) { return s.formula.design == design.design; });
      leave_out(design.why);
    }
  }
  if (all.empty()) {
    throw InputError(
        fmt::format("{}: is no machine that is built; see {} list", wanted, program_name()));
  }
  return all;
}

void keep_scripts(const std::string& folder, const std::string& title, const proof::Claim& claim) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format("{}: cannot be made: {}", folder, error.message()));
  const auto keep = [&](const std::string& what, const char* kind, const std::string& remark,
                        const std::string& text) {
    std::string name = fmt::format("{} {:.60} {}.{}", title, claim.what, what, kind);
    std::replace(name.begin(), name.end(), ' ', '_');
    std::replace(name.begin(), name.end(), '/', '_');
    std::erase(name, '=');  // z3 takes what has one for an option
    OutputFile file((fs::path(folder) / name).string());
    file.line("{} {}: {}; {}", remark, title, claim.what, what);
    file.text(text);
    file.close();
  };
  for (const proof::Query& query : claim.queries) {
    keep(query.asks.size() == 1 ? query.asks.front() : "each", "smt2", ";", query.script);
  }
  if (!claim.nets) return;
  const auto netlists = proof::netlists(*claim.nets);
  for (std::size_t i = 0; i < netlists.size(); ++i) {
    keep(claim.nets->asked[i].name, "blif", "#", netlists[i]);
  }
}

}  // namespace cosim::cli
