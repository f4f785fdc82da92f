// What a person wants to see of a machine that draws a path, beside its registers: in a waveform,
// for example.
#pragma once

#include <array>
#include <span>

#include "model/core/probe.h"

namespace cosim::plane {

/// What it does and the step of a clock, in these words, and the point before the step.
constexpr std::array<Probe, 4> path_probes(std::span<const char* const> phases,
                                           std::span<const char* const> steps) {
  using enum Probe::Kind;
  constexpr const char* path = "Path, in steps";
  constexpr int position = 40;  // bits
  return {{{"phase", words, "words", "", 4, {}, Probe::Side::expected, phases},
           {"step", words, "words", "", 4, {}, Probe::Side::actual, steps},
           {"x", analog, "path", path, position, Format::twos_complement},
           {"y", analog, "path", path, position, Format::twos_complement}}};
}

}  // namespace cosim::plane
