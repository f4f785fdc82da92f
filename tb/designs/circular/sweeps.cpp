#include "tb/designs/circular/sweeps.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "tb/designs/circular/figures.h"
#include "tb/sim/drawn_sweep.h"

namespace cosim::circular {
namespace {

std::uint64_t square(std::int64_t r) {
  return static_cast<std::uint64_t>(r) * static_cast<std::uint64_t>(r);
}

using Arcs = std::function<bool(Arc&)>;

Sweep over_radii(const CircularBench& bench, const char* name, std::int64_t first,
                 std::int64_t last, std::uint64_t cases_a_lane,
                 Arcs (*arcs_of)(std::int64_t radius)) {
  const auto radius = [first](std::uint64_t i) { return first + static_cast<std::int64_t>(i); };
  return drawn_sweep<ArcFigures>(
      bench, fmt::format("{}, R = {} to {}", name, first, last),
      static_cast<std::uint64_t>(last - first + 1),
      [=](std::uint64_t i) { return arcs_of(radius(i)); }, cases_a_lane,
      [=](std::uint64_t i) {
        return fmt::format("R = {}, {} arcs", radius(i), all_of<Arc>(arcs_of(radius(i))).size());
      });
}

// The points of every_start(), one after the other.
class Starts {
 public:
  explicit Starts(std::uint64_t radius2) : radius2_(radius2) {}
  std::optional<Point> next() {
    if (column_ < 0) {
      const Point at{nearest_on(row_, radius2_), row_};
      if (at.x > at.y) {
        ++row_;
        return at;
      }
      // The last column of sector 2, which may be one beside the last row of sector 1.
      column_ = row_ + 1;
      while (column_ >= 0 && nearest_on(column_, radius2_) < column_) --column_;
    }
    if (is_over_) return {};
    const Point at{column_, nearest_on(column_, radius2_)};
    if (column_-- == 0) {
      is_over_ = true;
      column_ = 0;
    }
    return at;
  }

 private:
  std::uint64_t radius2_;
  std::int64_t row_ = 0, column_ = -1;
  bool is_over_ = false;
};

}  // namespace

std::vector<Point> every_start(std::uint64_t radius2) {
  std::vector<Point> starts;
  for (Starts all(radius2); const auto start = all.next();) starts.push_back(*start);
  return starts;
}

Sweep every_radius(const CircularBench& bench, std::int64_t first, std::int64_t last) {
  return over_radii(bench, "every radius from (R, 0)", first, last, 8, [](std::int64_t r) -> Arcs {
    return [r, is_over = false](Arc& arc) mutable {
      arc = {{r, 0}, square(r), {}};
      return !std::exchange(is_over, true);
    };
  });
}

Sweep every_start(const CircularBench& bench, std::int64_t last) {
  return over_radii(bench, "every start of every radius", 1, last, 1, [](std::int64_t r) -> Arcs {
    return [r, all = Starts(square(r))](Arc& arc) mutable {
      const auto from = all.next();
      arc = {from.value_or(Point{}), square(r), {}};
      return from.has_value();
    };
  });
}

Sweep every_stop(const CircularBench& bench, std::int64_t last) {
  return over_radii(bench, "every early stop from every start", 1, last, 1,
                    [](std::int64_t r) -> Arcs {
                      return [all = Starts(square(r)), now = Arc{{}, square(r), {}},
                              stops = std::int64_t{0}, count = std::int64_t{0}](Arc& arc) mutable {
                        if (count == stops) {
                          const auto from = all.next();
                          if (!from) return false;
                          now.from = *from;
                          stops = steps_to_end(now.from, now.radius2) + 2;
                          count = 0;
                        }
                        arc = now;
                        arc.count = count++;
                        return true;
                      };
                    });
}

Arc random_arc(int width, std::uint64_t seed, std::uint64_t i) {
  constexpr std::int64_t longest = 3000;
  Random random = Random::for_case(seed, i);
  const std::int64_t radius = std::max<std::int64_t>(random.corner(width), 1);
  // Any R^2 that rounds to this radius: R^2 - R + 1 .. R^2 + R.
  const std::uint64_t r = static_cast<std::uint64_t>(radius);
  Arc arc;
  arc.radius2 = random.one_in_power(1) ? r * r : r * r - r + 1 + random.below(2 * r);

  // Rows or columns up to the middle of the quadrant, there and back again.
  const std::int64_t middle = nearest_root(arc.radius2 / 2);
  const bool late = random.one_in_power(1);
  std::int64_t along =
      static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(middle) + 1));
  if (random.one_in_power(2))
    along = std::max<std::int64_t>(middle - static_cast<std::int64_t>(random.below(20)), 0);
  const std::int64_t across = nearest_root(arc.radius2 - square(along));
  arc.from = late ? Point{along, across} : Point{across, along};
  if (!next_to_circle(arc.from, arc.radius2)) arc.from = {nearest_root(arc.radius2), 0};

  const std::int64_t steps = steps_to_end(arc.from, arc.radius2);
  if (steps > longest || random.one_in_power(2)) {
    arc.count = static_cast<std::int64_t>(
        random.below(static_cast<std::uint64_t>(std::min(steps, longest)) + 1));
  }
  return arc;
}

Sweep random_arcs(const CircularBench& bench, std::uint64_t seed, std::uint64_t count) {
  return drawn_sweep_of_one<ArcFigures>(
      bench, "random arcs", count,
      [w = width_of(bench.params()), seed](std::uint64_t i) { return random_arc(w, seed, i); },
      [seed](const Arc& arc) {
        return fmt::format("R^2 = {} from ({}, {}), {} steps, seed {}", arc.radius2, arc.from.x,
                           arc.from.y, arc.count ? fmt::format("{}", *arc.count) : "all", seed);
      });
}

}  // namespace cosim::circular
