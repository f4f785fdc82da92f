// A picture as a script of gnuplot, with its data in it.
#pragma once

#include <iosfwd>
#include <string>

#include "tb/plot/plot.h"

namespace cosim {

/// The picture goes into the file `path`, as its ending says.
void write_script(std::ostream& out, const std::string& path, const Plot& plot);

}  // namespace cosim
