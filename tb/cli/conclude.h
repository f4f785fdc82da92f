// How a command ends: the lines for a person, the report, the exit status.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tb/cli/common.h"
#include "tb/cli/wave.h"
#include "tb/sim/report.h"

namespace cosim::cli {

/// The outcome of one run of one job that `check` has watched.
template <class Check>
Outcome outcome_of(const AnyBench& bench, const std::string& work, Run run, Check& check) {
  return {&bench, work, result_of(std::move(run), check.so_far(), work)};
}

/// Prints what was compared and the verdict, then writes the report where one is asked for
/// (`extra`: more of its keys, a JSON object), then keeps the first mismatch in a folder, then
/// writes the page where one is asked for: of what is kept in a folder the page of that, else
/// of what there is to look at, and of the picture of --plot; `title` is that of several outcomes
/// or none. 0 where all matched, 1 where one did not; 2, with a line on standard error, where one
/// compared nothing and that is not allowed.
int conclude(const std::vector<Outcome>& outcomes, const Common& common,
             const std::string& extra = "{}", Looks looks = {}, const std::string& title = "");

}  // namespace cosim::cli
