// What a run says of itself: a few lines for a person, JSON for a program.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/bench.h"
#include "tb/sweep.h"

namespace cosim {

/// The outcome of one run on one bench.
struct Outcome {
  const AnyBench* bench = nullptr;
  std::string work;  ///< what was run, one line
  Result result;
};

/// "9 registers and 4 outputs"
std::string compared_signals(const AnyBench& bench);

/// The verdict of all outcomes in words, with the mismatch or the oracle's objection in full. Lines
/// end in '\n'.
std::string verdict_text(const std::vector<Outcome>& outcomes);

/// The report as JSON text. One outcome: its keys at the top. Several: sums at the top, and each
/// outcome under `runs`. `extra` is a JSON object whose keys are added at the top.
std::string report_json(const std::vector<Outcome>& outcomes, std::uint64_t seed,
                        const std::string& extra = "{}");

/// Writes the text to a file; an empty path writes nothing. InputError where it cannot.
void write_report(const std::string& path, const std::string& text);

}  // namespace cosim
