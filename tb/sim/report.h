// What a run says of itself: a few lines for a person, JSON for a program.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/sim/bench.h"
#include "tb/sim/sweep.h"
#include "tb/util/json_fwd.h"

namespace cosim {

/// The parameters of its shape by their names, an object.
Json parameters(const AnyBench& bench);

/// The outcome of one run on one bench.
struct Outcome {
  const AnyBench* bench = nullptr;
  std::string work;  ///< what was run, one line
  Result result;
};

bool all_match(const std::vector<Outcome>& outcomes);

/// "x: 12 in; y: 10 out, 10 compared"
std::string streams_text(const AnyBench& bench, const std::vector<Transactions>& all);

/// It matches, for it has compared nothing: no transaction of any stream, or no signal on any
/// clock.
bool compared_nothing(const Outcome& outcome);
/// What it did instead, and that `option` allows it, one line.
std::string nothing_text(const Outcome& outcome,
                         const std::string& option = "--allow-nothing-compared");

/// "match", "MISMATCH", or over none, or where one of them compared nothing, "nothing compared".
std::string verdict_of(const std::vector<Outcome>& outcomes);

/// What the check measured: "27 steps, largest deviation 1 step". If it measured nothing, the
/// number of clocks. With a mismatch only the totals, for the jobs were not drawn to their ends.
std::string measured_text(const Result& result);

/// The same after the number of cases, where they are jobs.
std::string swept_text(const Result& result);

/// "9 registers and 4 outputs"; "5 to 21 registers and 4 outputs" where the shapes of the design
/// have not as many.
std::string compared_signals(const std::vector<const AnyBench*>& shapes);

/// How many of the cases happened, and a line for each of the first 20 that never did; `of` stands
/// behind the first words.
std::string cases_text(const std::string& of, const std::vector<std::string>& cases,
                       const std::vector<std::uint64_t>& happened);

/// What was compared and over how many clocks, one line a design, with its name if there are
/// several, a line with the transactions of its streams, those of cases_text(), a line on what is
/// not compared, one for each thing that is assumed of its inputs, and one for each field that was
/// not compared on every clock and each stream that was never compared. Lines end in '\n', here and
/// below.
std::string comparison_text(const std::vector<Outcome>& outcomes);

/// Every mismatch and every error of an oracle in full, then the verdict of all outcomes.
std::string verdict_text(const std::vector<Outcome>& outcomes);

/// The report as JSON text: an object with `verdict`, `design`, `parameters`, `clocks`, the
/// measures of the design's check under their names, `compared_signals`, `seed`, where they do not
/// match `mismatch`, and `runs`, an object for each outcome; where
/// something is assumed of the inputs `assumed`, sentences; where
/// registers or outputs are not compared `unobserved`, their paths; of a design with streams
/// `streams`, under the name of each how many transactions went `in`, or came `out` and were
/// `compared`, and under `cases` how often each case happened; where
/// something was not always compared `left_out`, the number of clocks under each name, and
/// `never_compared`, the names of what was left out on all of them. Over several outcomes clocks
/// are added up, measures are combined as they say, mismatch is the first, and parameters is an
/// array of objects; over several designs design is an array of names and compared_signals an
/// object of arrays under these names. Over none the verdict is "nothing compared". `extra` is a
/// JSON object whose keys are added. Text that is not UTF-8 gets replacement characters.
std::string report_json(const std::vector<Outcome>& outcomes, std::uint64_t seed,
                        const std::string& extra = "{}");

/// What of that report is in `runs` for one outcome: a JSON object.
std::string run_json(const Outcome& outcome);

/// Writes the text to a file, as OutputFile does. An empty path writes nothing.
void write_report(const std::string& path, const std::string& text);

}  // namespace cosim
