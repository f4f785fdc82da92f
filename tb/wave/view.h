// The GTKWave view of a wave: its save file and the words for phases and steps.
#pragma once

#include <cstdint>
#include <string>

#include "tb/wave/wave.h"

namespace cosim {

/// Nanoseconds of one clock in a wave.
inline constexpr std::uint64_t wave_period = 10;

/// True for a field that GTKWave cannot read by itself, so that the wave has its number too.
bool has_number(const Field& field);
/// That number, its fraction bits behind the point.
double number_of(const Field& field, Word value);

/// The files of a view, which lie beside its wave `path`, x.fst, and belong together: x.gtkw, and
/// the words x.phase.txt and x.step.txt.
struct ViewFiles {
  explicit ViewFiles(const std::string& path);
  std::string view, phases, steps;
};

/// Writes the view of wave `path`, a file whose name ends in .fst. InputError where it cannot.
void write_view(const std::string& path, const WaveShape& shape, const WaveRange& range);

}  // namespace cosim
