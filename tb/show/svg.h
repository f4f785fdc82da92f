// A wave as SVG for a page: the names, which stay where they are, and beside them the clocks, which
// scroll. All text is text. The style is in tb/sim/page.css.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cosim {

/// One trace, or the heading of those below it.
struct SvgRow {
  enum class Kind { heading, flag, bus, curve };
  enum class Side { plain, expected, actual };
  Kind kind = Kind::flag;
  Side side = Side::plain;
  std::string name;
  std::string meaning{};  ///< shown where the pointer rests on the name

  // One a clock.
  std::vector<std::string> text{};
  std::vector<double> number{};    ///< of a flag 0 or 1, and of a curve
  std::vector<double> expected{};  ///< of a curve that is drawn over another one; else empty
  std::vector<bool> differs{};     ///< from what is expected, or what is there from it
  std::vector<bool> left_out{};    ///< it means nothing there; empty: it always does
  /// Of a value that differs the one it differs from: where there is no room for all of it, the
  /// part is shown that is not the same. May be empty.
  std::vector<std::string> other{};
};

struct SvgClocks {
  std::uint64_t first = 0;
  std::size_t count = 0;
  std::optional<std::uint64_t> mismatch;  ///< the clock that is marked
};

std::string wave_svg(const std::vector<SvgRow>& rows, const SvgClocks& clocks);

/// Two paths on a grid, point by point, the first ones first: what is expected and what is there.
struct SvgPath {
  std::vector<std::pair<double, double>> expected, actual;
};
/// Both over each other; where they part is marked. Empty where no point differs from the first.
std::string path_svg(const SvgPath& path);

}  // namespace cosim
