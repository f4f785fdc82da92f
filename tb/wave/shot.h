// A wave as GTKWave shows it, without a display.
#pragma once

#include <string>

namespace cosim {

/// Renders the wave `fst`, with the view beside it, into `png`. InputError where GTKWave or Xvfb is
/// not installed or they do not.
void shoot(const std::string& fst, const std::string& png);

}  // namespace cosim
