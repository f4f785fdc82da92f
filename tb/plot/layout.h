// Where everything stands in a picture, in pixels from its upper left corner.
#pragma once

#include "tb/plot/plot.h"

namespace cosim {

/// Colours and bars show no difference above this deviation, in steps.
inline constexpr double worst_shown = 2;

struct Box {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// Panels side by side, all alike and on the same scales: a path, and below it the bars of its
/// deviations.
struct Layout {
  int columns = 0;
  int width = 0;  ///< of the picture
  int height = 0;
  Box path;     ///< of the first panel
  Box bars;     ///< likewise
  Box colours;  ///< the scale of colours
  int panel_width = 0;
  int panel_height = 0;

  double x0 = 0, x1 = 0, y0 = 0, y1 = 0;  ///< the part of the grid that is shown; a step is square
  double length = 1;                      ///< of the longest path, in steps
  double top = 0;                         ///< of the bars, in steps: 0.5 to worst_shown

  /// The place of a box of the first panel in another panel.
  Box in(int panel, Box box) const;
  double pixels_a_step() const { return path.width / (x1 - x0); }
};

Layout layout_of(const Plot& plot);

}  // namespace cosim
