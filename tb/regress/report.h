// What came of a run, put together from its shards. report.json and report.txt are the same for
// every way in which the run was cut, killed and gone on with; times and hosts are in times.json.
#pragma once

#include <string>
#include <vector>

#include "tb/regress/results.h"
#include "tb/regress/run_folder.h"

namespace cosim::regress {

/// Which shards there is still something to be done of: neither done, nor behind a failure after
/// which nothing is looked at. `works`: for each work whether that is so (Work::ends_at_failure).
std::vector<std::uint64_t> missing(const RunFolder& run, const Results& results,
                                   const std::vector<bool>& ends_at_failure);

/// What Work::ends_at_failure says, by work.
std::vector<bool> ends_at_failure(const RunFolder& run, const Kinds& kinds);

struct Report {
  bool holds = false;  ///< all was run, and all of it holds
  Json json;           ///< of report.json
  std::string text;    ///< of report.txt: the failures first
};

/// The report. Works with missing shards are `unfinished` in it.
Report report(const RunFolder& run, const Kinds& kinds, const Results& results);

/// Writes report.json, report.txt and times.json. InputError where they cannot be written.
void write_report(const RunFolder& run, const Results& results, const Report& report);

}  // namespace cosim::regress
