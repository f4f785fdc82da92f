#include "tb/designs/dda/sweeps.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "model/core/input_error.h"
#include "tb/designs/dda/figures.h"
#include "tb/sim/drawn_sweep.h"

namespace cosim::dda {
namespace {

constexpr Preload preloads[] = {Preload::zero, Preload::half};
constexpr Update updates[] = {Update::parallel, Update::sequential};

// Any number of the width, either sign.
std::int64_t either_sign(int width, Random& random) {
  const Word size = random.corner(width);
  return random.one_in_power(1) ? size : -size;
}

Settings random_settings(Random& random) {
  return {random.one_in_power(1) ? Update::parallel : Update::sequential,
          random.one_in_power(1) ? Preload::zero : Preload::half, random.one_in_power(1)};
}

Job random_arc(int width, Random& random, const Settings& settings) {
  const auto radius = static_cast<double>(std::max<Word>(random.corner(width), 1));
  const auto column = [&] { return static_cast<double>(random.below(1001)) / 1000 * radius; };
  double from_x = column(), to_x = column();
  if (from_x < to_x) std::swap(from_x, to_x);
  const auto on = [&](double x) {
    const auto row =
        static_cast<std::int64_t>(std::sqrt(radius * radius - std::floor(x) * std::floor(x)));
    return Point{static_cast<std::int64_t>(x), row};
  };
  return arc(width, on(from_x), on(to_x), settings);
}

// An ellipse or a hyperbola whose coefficients leave room for its coordinates.
Job random_conic(int width, Random& random, const Settings& settings) {
  const auto small = [&](int bits) {
    return static_cast<std::int64_t>(random.below(std::uint64_t{1} << bits));
  };
  const int bits = std::max(1, width / 4);
  const std::int64_t sign = random.one_in_power(1) ? 1 : -1;
  Conic q{sign * (1 + small(bits)),  small(bits) - small(bits), sign * (1 + small(bits)),
          small(bits) - small(bits), small(bits) - small(bits), 0};
  const Point from{small(width / 2) - small(width / 2), small(width / 2)};
  q.f = -(q.a * from.x * from.x + q.b * from.x * from.y + q.c * from.y * from.y + q.d * from.x +
          q.e * from.y);
  return conic(width, q, from, settings, 1 + small(12));
}

constexpr std::int64_t longest = 3000;

// A job that is long, and others, are stopped after a random number of clocks.
void give_up(int width, Random& random, Job& job) {
  if (!random.one_in_power(2) && width <= 11) return;
  job.clocks =
      std::min(job.clocks.value_or(longest), static_cast<std::int64_t>(random.below(longest)));
}

using Jobs = std::function<bool(Job&)>;

std::string with_seed(const Job& job, std::uint64_t seed) {
  return fmt::format("{}, seed {}", describe(job), seed);
}

}  // namespace

Sweep every_line(const DdaBench& bench) {
  const std::int64_t most = ones(width_of(bench.params()));
  const auto lines_of = [width = width_of(bench.params()), most](std::uint64_t i) -> Jobs {
    const std::int64_t x = static_cast<std::int64_t>(i) - most;
    return [width, x, y = -most, most, kind = 0U](Job& job) mutable {
      if (y > most) return false;
      job = line(width, {x, y}, {updates[kind & 1], preloads[kind >> 1 & 1], (kind & 4) != 0});
      kind = (kind + 1) % 8;
      if (kind == 0) ++y;
      return true;
    };
  };
  return drawn_sweep<CurveFigures>(
      bench, "every DX with every DY", static_cast<std::uint64_t>(2 * most + 1), lines_of, 1,
      [most](std::uint64_t i) {
        return fmt::format("DX = {} with every DY", static_cast<std::int64_t>(i) - most);
      });
}

Sweep every_quarter(const DdaBench& bench) {
  const auto quarters_of = [width = width_of(bench.params())](std::uint64_t i) -> Jobs {
    return [width, radius = static_cast<std::int64_t>(i) + 1, kind = 0U](Job& job) mutable {
      if (kind == 4) return false;
      job = arc(width, {radius, 0}, {0, radius}, {updates[kind >> 1], preloads[kind & 1], false});
      ++kind;
      return true;
    };
  };
  return drawn_sweep<CurveFigures>(bench, "every quarter from (R, 0)",
                                   static_cast<std::uint64_t>(ones(width_of(bench.params()))),
                                   quarters_of, 1,
                                   [](std::uint64_t i) { return fmt::format("R = {}", i + 1); });
}

Job random_job(int width, std::uint64_t seed, std::uint64_t i) {
  Random random = Random::for_case(seed, i);
  const Settings settings = random_settings(random);
  Job job;
  try {
    switch (random.below(4)) {
      case 0:
        job = line(width, {either_sign(width, random), either_sign(width, random)}, settings);
        break;
      case 1:
        job = random_arc(width, random, settings);
        break;
      case 2:
        job = circle(width, std::max<Word>(random.corner(width) / 2, 1), settings,
                     static_cast<std::int64_t>(random.below(longest)));
        break;
      default:
        job = random_conic(width, random, settings);
    }
  } catch (const InputError&) {  // it leaves the registers: a line in its place
    job = line(width, {either_sign(width, random), either_sign(width, random)}, settings);
  }
  give_up(width, random, job);
  return job;
}

Sweep random_lines_and_arcs(const DdaBench& bench, std::uint64_t seed, std::uint64_t count) {
  const auto one = [width = width_of(bench.params()), seed](std::uint64_t i) {
    Random random = Random::for_case(seed, i);
    const Settings settings = random_settings(random);
    Job job = random.one_in_power(1)
                  ? random_arc(width, random, settings)
                  : line(width, {either_sign(width, random), either_sign(width, random)}, settings);
    give_up(width, random, job);
    return job;
  };
  return drawn_sweep_of_one<CurveFigures>(bench, "random lines and arcs", count, one,
                                          [seed](const Job& job) { return with_seed(job, seed); });
}

Sweep random_jobs(const DdaBench& bench, std::uint64_t seed, std::uint64_t count) {
  const int width = width_of(bench.params());
  Sweep sweep = drawn_sweep_of_one<CurveFigures>(
      bench, "random lines, arcs and conics", count,
      [=](std::uint64_t i) { return random_job(width, seed, i); },
      [=](const Job& job) { return with_seed(job, seed); });
  sweep.in_lanes = nullptr;  // of conics they measure no deviation
  return sweep;
}

}  // namespace cosim::dda
