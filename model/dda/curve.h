// What the method leaves to the device outside: what to write into the registers for a curve.
#pragma once

#include <cstdint>
#include <optional>

#include "model/dda/conic.h"

namespace cosim::dda {

/// When the rate of Y follows a step of X.
enum class Update {
  parallel,    ///< on the next clock: the source's hardware
  sequential,  ///< on the same one: the source's flow chart
};

/// What an accumulator holds at the start, of the 2^width that make a step. An axis that goes
/// backwards starts from the ones' complement of it, so that both directions step alike.
enum class Preload { zero, half };

struct Settings {
  Update update = Update::parallel;
  Preload preload = Preload::zero;
  bool normalise = true;  ///< of a line: shift both rates up first
};

/// What is written into the registers, by their names: numbers.
struct Start {
  bool sequential = false, normalise = false, free = false;
  std::int64_t sx = 0, sy = 0, rate_x = 0, rate_y = 0, x = 0, y = 0, left_x = 0, left_y = 0;
  std::int64_t two_a = 0, b = 0, two_c = 0;
  friend bool operator==(const Start&, const Start&) = default;
};

/// One piece of work for the machine: its start, and the clocks it may run, those that shift
/// included, before it is stopped; none: to its own end, which it then has.
struct Job {
  Start start;
  std::optional<std::int64_t> clocks;
};

/// The line from (0, 0) to `to`. InputError where a coordinate is 2^width or more in size.
Job line(int width, Point to, const Settings& settings);

/// The arc about (0, 0) in the first quadrant, anticlockwise, as many steps as lie between the two
/// ends. InputError where they are not 0 <= to.x <= from.x < 2^width, 0 <= from.y <= to.y <
/// 2^width, where `from` is (0, 0) and where their radii are one step or more apart.
Job arc(int width, Point from, Point to, const Settings& settings);

/// A circle about (0, 0) from (radius, 0), anticlockwise, until a stop after `clocks`, or after a
/// full turn. InputError as for a conic.
Job circle(int width, std::int64_t radius, const Settings& settings,
           std::optional<std::int64_t> clocks = {});

/// A conic from `from` until a stop after `clocks`; an ellipse may do without: one turn. InputError
/// where check() or rates_at() refuses it, a coefficient or a coordinate does not fit, another
/// curve than an ellipse has no `clocks`, there are 2^28 of them or more, or a rate or a code
/// leaves its register on the way.
Job conic(int width, const Conic& conic, Point from, const Settings& settings,
          std::optional<std::int64_t> clocks = {});

}  // namespace cosim::dda
