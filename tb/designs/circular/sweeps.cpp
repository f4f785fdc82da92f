#include "tb/designs/circular/sweeps.h"

#include <fmt/core.h>

#include <algorithm>

#include "tb/designs/circular/check.h"

namespace cosim::circular {
namespace {

std::uint64_t square(std::int64_t r) {
  return static_cast<std::uint64_t>(r) * static_cast<std::uint64_t>(r);
}

Sweep over_radii(const CircularBench& bench, const char* name, std::int64_t first,
                 std::int64_t last, std::vector<Arc> (*arcs_of)(std::int64_t radius)) {
  const auto run = [&bench, first, arcs_of](std::uint64_t i) {
    const std::int64_t radius = first + static_cast<std::int64_t>(i);
    const std::vector<Arc> arcs = arcs_of(radius);
    Result result = run_arcs(bench, arcs, static_cast<std::uint32_t>(i));
    result.failed = fmt::format("R = {}, {} arcs", radius, arcs.size());
    return result;
  };
  return {fmt::format("{}, R = {} to {}", name, first, last),
          static_cast<std::uint64_t>(last - first + 1), run};
}

}  // namespace

Result run_arcs(const CircularBench& bench, std::span<const Arc> arcs, std::uint32_t power_up) {
  Check check(arcs);
  return result_of(bench.open(power_up)->draw(arcs, check), check);
}

std::vector<Point> every_start(std::uint64_t radius2) {
  std::vector<Point> starts;
  for (std::int64_t y = 0;; ++y) {
    const std::int64_t x = nearest_on(y, radius2);
    if (x <= y) break;
    starts.push_back({x, y});
  }
  std::vector<Point> sector2;
  for (std::int64_t x = 0;; ++x) {
    const std::int64_t y = nearest_on(x, radius2);
    if (y < x) break;
    sector2.push_back({x, y});
  }
  starts.insert(starts.end(), sector2.rbegin(), sector2.rend());
  return starts;
}

Sweep every_radius(const CircularBench& bench, std::int64_t first, std::int64_t last) {
  return over_radii(bench, "every radius from (R, 0)", first, last, [](std::int64_t r) {
    return std::vector<Arc>{{{r, 0}, square(r), {}}};
  });
}

Sweep every_start(const CircularBench& bench, std::int64_t last) {
  return over_radii(bench, "every start of every radius", 1, last, [](std::int64_t r) {
    std::vector<Arc> arcs;
    for (const Point& p : every_start(square(r))) arcs.push_back({p, square(r), {}});
    return arcs;
  });
}

Sweep every_stop(const CircularBench& bench, std::int64_t last) {
  return over_radii(bench, "every early stop from every start", 1, last, [](std::int64_t r) {
    std::vector<Arc> arcs;
    for (const Point& p : every_start(square(r))) {
      const std::int64_t steps = steps_to_end(p, square(r));
      for (std::int64_t count = 0; count <= steps + 1; ++count) {
        arcs.push_back({p, square(r), count});
      }
    }
    return arcs;
  });
}

Arc random_arc(const Params& p, std::uint64_t seed, std::uint64_t i) {
  constexpr std::int64_t longest = 3000;
  Random random = Random::for_case(seed, i);
  const std::int64_t radius = std::max<std::int64_t>(random.corner(p.width), 1);
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
  const auto run = [&bench, seed](std::uint64_t i) {
    const Arc arc = random_arc(bench.params(), seed, i);
    Result result = run_arcs(bench, {&arc, 1}, static_cast<std::uint32_t>(i));
    result.failed =
        fmt::format("R^2 = {} from ({}, {}), {} steps, seed {}", arc.radius2, arc.from.x,
                    arc.from.y, arc.count ? fmt::format("{}", *arc.count) : "all", seed);
    return result;
  };
  return {"random arcs", count, run};
}

}  // namespace cosim::circular
