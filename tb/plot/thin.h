// A picture shows no more than its pixels: of the many marks on one, the worst.
#pragma once

#include <functional>
#include <vector>

#include "tb/plot/plot.h"

namespace cosim {

/// The cell that a mark falls into.
using Cell = std::function<std::pair<std::int64_t, std::int64_t>(const Mark&)>;

/// Of each cell the mark that is furthest off, ascending by how far: what is drawn later, and so
/// stays to be seen, is worse.
std::vector<Mark> worst_of_cells(const std::vector<Mark>& marks, const Cell& cell);

}  // namespace cosim
