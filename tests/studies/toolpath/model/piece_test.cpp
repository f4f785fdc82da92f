#include "model/toolpath/piece.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace cosim::toolpath {
namespace {

TEST(LinePiece, TakesEveryOctantToItsTarget) {
  for (std::int64_t dx = -3; dx <= 3; ++dx) {
    for (std::int64_t dy = -3; dy <= 3; ++dy) {
      if (dx == 0 && dy == 0) continue;
      const Piece piece = line_piece(7, {10, -20}, {10 + dx, -20 + dy});
      const auto& line = std::get<LineJob>(piece.job);
      EXPECT_EQ(piece.segment, 7u);
      EXPECT_EQ(line.major, std::max(std::abs(dx), std::abs(dy)));
      EXPECT_EQ(line.minor, std::min(std::abs(dx), std::abs(dy)));
      EXPECT_EQ(steps(piece), line.major);
      EXPECT_EQ(piece.orientation.to_plane({line.major, line.minor}), (Point{dx, dy}));
      EXPECT_EQ(piece.orientation.to_machine({dx, dy}), (Point{line.major, line.minor}));
    }
  }
}

TEST(LinePiece, HoldsTheLongestLine) {
  constexpr std::int64_t far = (std::int64_t{1} << 31) - 1;
  const Piece piece = line_piece(1, {far, -far}, {-far, far});
  EXPECT_EQ(std::get<LineJob>(piece.job).major, 2 * far);
  EXPECT_EQ(piece.orientation.to_plane({2 * far, 2 * far}), (Point{-2 * far, 2 * far}));
}

}  // namespace
}  // namespace cosim::toolpath
