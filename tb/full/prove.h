// What `prove` does, in parts.
#pragma once

#include <string>
#include <vector>

#include "tb/cli/common.h"
#include "tb/cli/registry.h"
#include "tb/cli/verdicts.h"
#include "tb/proof/decide.h"
#include "tb/proof/machines.h"
#include "tb/proof/theorems.h"

namespace cosim::cli {

constexpr int kLongest = 86400;  ///< seconds that an engine may be given

struct ProveOptions {
  Common common;
  std::vector<std::string> machine;
  Text rtl, limit, jobs, engines, keep, mutants, mutant, count;
  bool theorems = false;
};

/// A machine that something can be proved of.
struct ProveSubject {
  std::string title;
  nets::Model model;
  proof::Source source;  ///< the RTL it was built from
};
/// Those that begin with these words; all where there are none. InputError where there is none;
/// says why others of them are left out.
std::vector<ProveSubject> subjects_of(const std::vector<std::string>& words);

/// Each gives the exit status; the first two add a verdict of each claim.
int prove_machines(const ProveOptions& o, const proof::Asking& asking, Verdicts& verdicts);
int prove_theorems(const ProveOptions& o, int limit, unsigned jobs, Verdicts& verdicts);
int prove_mutants(const ProveOptions& o, const Registry& registry, const proof::Asking& asking);

/// Writes what the engines are asked of a claim on `title` into a folder, a file each: binary
/// AIGER, whose comment says what it is.
void keep_questions(const std::string& folder, const std::string& title, const std::string& claim,
                    const proof::Questions& questions);
/// The same of a theorem; of one on integers a script of SMT-LIB 2.
void keep_questions(const std::string& folder, const proof::Theorem& theorem);
/// Says how to give an engine more time, as a last line.
void say_limit(int limit);

}  // namespace cosim::cli
