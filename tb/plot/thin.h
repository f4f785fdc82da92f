// Keeps the worst of the marks that fall on the same pixels of a picture.
#pragma once

#include <functional>
#include <vector>

#include "tb/plot/plot.h"

namespace cosim {

/// The cell that a mark falls into.
using Cell = std::function<std::pair<std::int64_t, std::int64_t>(const Mark&)>;

/// Of each cell the mark that is furthest off, in ascending order: the worst are drawn last and
/// stay visible.
std::vector<Mark> worst_of_cells(const std::vector<Mark>& marks, const Cell& cell);

}  // namespace cosim
