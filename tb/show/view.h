// The GTKWave view of a wave: its save file and the words that its probes stand for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/show/wave_shape.h"

namespace cosim {

/// Nanoseconds of one clock in a wave.
inline constexpr std::uint64_t wave_period = 10;

/// True for a field that GTKWave cannot read by itself, so that the wave has its number too.
bool has_number(const Field& field);
/// That number, with its fraction.
double number_of(const Field& field, Word value);

/// The view of wave `path`, x.fst, which lies beside it: x.gtkw.
std::string view_file(const std::string& path);
/// The words of a probe, which belong to the view: x.PROBE.txt.
std::string words_file(const std::string& path, const Probe& probe);
/// All that lie beside the wave, the view first.
std::vector<std::string> view_files(const std::string& path, const std::vector<Probe>& probes);

/// Writes the view of wave `path`, a file whose name ends in .fst. InputError where it cannot.
void write_view(const std::string& path, const WaveShape& shape, const WaveRange& range);

/// Renders the wave `fst`, with the view beside it, into `png`. InputError where GTKWave or Xvfb is
/// not installed or they do not.
void shoot(const std::string& fst, const std::string& png);

}  // namespace cosim
