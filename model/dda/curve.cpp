#include "model/dda/curve.h"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include "model/core/input_error.h"
#include "model/dda/oracle.h"

namespace cosim::dda {
namespace {

constexpr std::int64_t most_clocks = std::int64_t{1} << 28;

[[noreturn]] void refuse(const char* what, const std::string& why) {
  throw InputError(std::string(what) + ": " + why);
}

bool fits(const Params& p, std::int64_t v) {
  return v < shift_left(1, p.width) && v > -shift_left(1, p.width);
}

void check_fits(const Params& p, const char* what, const char* name, std::int64_t v) {
  if (fits(p, v)) return;
  refuse(what, std::string(name) + " = " + std::to_string(v) +
                   " does not fit dda W=" + std::to_string(p.width) + ": it must be below 2^" +
                   std::to_string(p.width) + " in size");
}

Word preload(const Params& p, Preload at, bool backwards) {
  const Word forwards = at == Preload::half ? shift_left(1, p.width - 1) : 0;
  return backwards ? ones(p.width) - forwards : forwards;
}

Job job_of(const Params& p, Point from, Point rates, const Conic& q, const Settings& settings) {
  Job job;
  State<Word>& s = job.start;
  s.sequential = settings.update == Update::sequential;
  // A rate that is 0 goes where the other axis first takes it.
  const bool left = rates.x == 0 && (q.c < 0 ? rates.y < 0 : q.c > 0 && rates.y > 0);
  const bool down = rates.y == 0 && (q.a < 0 ? rates.x > 0 : q.a > 0 && rates.x < 0);
  s.sx = preload(p, settings.preload, rates.x < 0 || left);
  s.sy = preload(p, settings.preload, rates.y < 0 || down);
  s.x = from.x;
  s.y = from.y;
  s.rate_x = rates.x;
  s.rate_y = rates.y;
  s.two_a = 2 * q.a;
  s.b = q.b;
  s.two_c = 2 * q.c;
  return job;
}

// A circle's registers: 2 A = 2 C = 1, so that the rates are the point itself.
Job circle_from(const Params& p, Point from, const Settings& settings) {
  Job job = job_of(p, from, {-from.y, from.x}, {1, 0, 1, 0, 0, 0}, settings);
  job.start.two_a = job.start.two_c = 1;
  return job;
}

// Walks the whole way.
void check_way(const Params& p, const Job& job, const char* what) {
  const std::string machine = "dda W=" + std::to_string(p.width);
  Track track(p, job);
  for (std::int64_t clock = 0;; ++clock) {
    const Point at = track.at();
    for (const Point rates : {track.rates(), track.added()}) {
      if (fits(p, rates.x) && fits(p, rates.y)) continue;
      refuse(what, "its rates overflow " + machine + " at " + text(at) + " on clock " +
                       std::to_string(clock) + ": they are " + text(rates));
    }
    if (!fits(p, at.x) || !fits(p, at.y)) {
      refuse(what, "it leaves the codes of " + machine + " at " + text(at));
    }
    if (!track.next()) return;
  }
}

Job until(const Params& p, Job job, std::int64_t clocks, const char* what) {
  if (clocks < 0 || clocks >= most_clocks) {
    refuse(what, std::to_string(clocks) + " clocks are not from 0 to 2^28 - 1; take a smaller " +
                     "width or say how many");
  }
  job.start.free = 1;
  job.clocks = clocks;
  check_way(p, job, what);
  return job;
}

// A turn of an ellipse is 2 pi of the time in which its rates are added 2^width times, by the root
// of 4 A C - B^2.
std::int64_t turn(const Params& p, double root) {
  return std::llround(2 * std::numbers::pi * std::ldexp(1, p.width) / root);
}

}  // namespace

Job line(const Params& p, Point to, const Settings& settings) {
  check_fits(p, "line", "DX", to.x);
  check_fits(p, "line", "DY", to.y);
  Job job = job_of(p, {0, 0}, to, {}, settings);
  State<Word>& s = job.start;
  s.normalise = settings.normalise;
  s.left_x = std::abs(to.x);
  s.left_y = std::abs(to.y);
  return job;
}

Job arc(const Params& p, Point from, Point to, const Settings& settings) {
  const bool inside = 0 <= to.x && to.x <= from.x && 0 <= from.y && from.y <= to.y;
  if (!inside || from == Point{}) {
    refuse("arc",
           text(from) + " to " + text(to) + " does not go left and up in the first quadrant");
  }
  check_fits(p, "arc", "X", from.x);
  check_fits(p, "arc", "Y", to.y);
  const auto radius = [](Point at) {
    return std::hypot(static_cast<double>(at.x), static_cast<double>(at.y));
  };
  if (std::fabs(radius(from) - radius(to)) >= 1) {
    refuse("arc", text(to) + " is off the circle of " + text(from));
  }
  Job job = circle_from(p, from, settings);
  job.start.left_x = from.x - to.x;
  job.start.left_y = to.y - from.y;
  // An end that the machine passes would never be reached: the device outside gives up.
  job.clocks = shift_left(1, p.width + 2);
  return job;
}

Job circle(const Params& p, std::int64_t radius, const Settings& settings,
           std::optional<std::int64_t> clocks) {
  if (radius < 1) refuse("circle", "R = " + std::to_string(radius) + " is no radius");
  check_fits(p, "circle", "R", radius);
  return until(p, circle_from(p, {radius, 0}, settings), clocks.value_or(turn(p, 1)), "circle");
}

Job conic(const Params& p, const Conic& q, Point from, const Settings& settings,
          std::optional<std::int64_t> clocks) {
  check(q);
  check_fits(p, "conic", "2 A", 2 * q.a);
  check_fits(p, "conic", "B", q.b);
  check_fits(p, "conic", "2 C", 2 * q.c);
  check_fits(p, "conic", "X", from.x);
  check_fits(p, "conic", "Y", from.y);
  const Job job = job_of(p, from, rates_at(q, from), q, settings);
  const std::optional<double> root = ellipse_root(q);
  if (!clocks && !root) refuse("conic", "it is no ellipse and has no end: it needs clocks");
  return until(p, job, clocks ? *clocks : turn(p, *root), "conic");
}

}  // namespace cosim::dda
