// --wave and --html: what a run drew, drawn again as a waveform and for a page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tb/cli/common.h"
#include "tb/sim/bench.h"
#include "tb/sim/page.h"

namespace cosim::cli {

/// FILE.fst of --wave, or FILE.part.fst if there are several waves.
std::string wave_file(const std::string& file, const std::string& part = "");

/// What the page of --html shows of a run; nothing where it is not asked for.
using Looks = std::vector<Page::Part>;

/// Draws the stimulus where --wave or --html asks for it: the window around its mismatch, or all of
/// it. `part` as of wave_file. InputError where it is too long to be drawn.
Looks draw_wave(const Common& common, const AnyBench& bench, Stimulus stimulus,
                const std::string& work, const std::string& part = "");

/// The same of everything a session drew. A mismatch is shown with the clocks after it.
template <class Design>
Looks draw_wave(const Common& common, const AnyBench& bench, const std::string& work,
                const Session<Design>& session, const std::optional<Mismatch>& mismatch,
                const std::string& part = "") {
  if (!common.wave && !common.html) return {};
  return draw_wave(common, bench, mismatch ? mismatch->stimulus : session.stimulus(), work, part);
}

}  // namespace cosim::cli
