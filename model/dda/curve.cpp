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

std::int64_t power(int n) { return std::int64_t{1} << n; }

bool fits(int width, std::int64_t v) { return v < power(width) && v > -power(width); }

void check_fits(int width, const char* what, const char* name, std::int64_t v) {
  if (fits(width, v)) return;
  refuse(what, std::string(name) + " = " + std::to_string(v) +
                   " does not fit dda W=" + std::to_string(width) + ": it must be below 2^" +
                   std::to_string(width) + " in size");
}

std::int64_t preload(int width, Preload at, bool backwards) {
  const std::int64_t forwards = at == Preload::half ? power(width - 1) : 0;
  return backwards ? power(width) - 1 - forwards : forwards;
}

Job job_of(int width, Point from, Point rates, const Conic& q, const Settings& settings) {
  Job job;
  Start& s = job.start;
  s.sequential = settings.update == Update::sequential;
  // A rate that is 0 goes where the other axis first takes it.
  const bool left = rates.x == 0 && (q.c < 0 ? rates.y < 0 : q.c > 0 && rates.y > 0);
  const bool down = rates.y == 0 && (q.a < 0 ? rates.x > 0 : q.a > 0 && rates.x < 0);
  s.sx = preload(width, settings.preload, rates.x < 0 || left);
  s.sy = preload(width, settings.preload, rates.y < 0 || down);
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
Job circle_from(int width, Point from, const Settings& settings) {
  Job job = job_of(width, from, {-from.y, from.x}, {1, 0, 1, 0, 0, 0}, settings);
  job.start.two_a = job.start.two_c = 1;
  return job;
}

// Walks the whole way.
void check_way(int width, const Job& job, const char* what) {
  const std::string machine = "dda W=" + std::to_string(width);
  Track track(width, job);
  for (std::int64_t clock = 0;; ++clock) {
    const Point at = track.at();
    for (const Point rates : {track.rates(), track.added()}) {
      if (fits(width, rates.x) && fits(width, rates.y)) continue;
      refuse(what, "its rates overflow " + machine + " at " + text(at) + " on clock " +
                       std::to_string(clock) + ": they are " + text(rates));
    }
    if (!fits(width, at.x) || !fits(width, at.y)) {
      refuse(what, "it leaves the codes of " + machine + " at " + text(at));
    }
    if (!track.next()) return;
  }
}

Job until(int width, Job job, std::int64_t clocks, const char* what) {
  if (clocks < 0 || clocks >= most_clocks) {
    refuse(what, std::to_string(clocks) + " clocks are not from 0 to 2^28 - 1; take a smaller " +
                     "width or say how many");
  }
  job.start.free = true;
  job.clocks = clocks;
  check_way(width, job, what);
  return job;
}

// A turn of an ellipse is 2 pi of the time in which its rates are added 2^width times, by the root
// of 4 A C - B^2.
std::int64_t turn(int width, double root) {
  return std::llround(2 * std::numbers::pi * std::ldexp(1, width) / root);
}

}  // namespace

Job line(int width, Point to, const Settings& settings) {
  check_fits(width, "line", "DX", to.x);
  check_fits(width, "line", "DY", to.y);
  Job job = job_of(width, {0, 0}, to, {}, settings);
  Start& s = job.start;
  s.normalise = settings.normalise;
  s.left_x = std::abs(to.x);
  s.left_y = std::abs(to.y);
  return job;
}

Job arc(int width, Point from, Point to, const Settings& settings) {
  const bool inside = 0 <= to.x && to.x <= from.x && 0 <= from.y && from.y <= to.y;
  if (!inside || from == Point{}) {
    refuse("arc",
           text(from) + " to " + text(to) + " does not go left and up in the first quadrant");
  }
  check_fits(width, "arc", "X", from.x);
  check_fits(width, "arc", "Y", to.y);
  const auto radius = [](Point at) {
    return std::hypot(static_cast<double>(at.x), static_cast<double>(at.y));
  };
  if (std::fabs(radius(from) - radius(to)) >= 1) {
    refuse("arc", text(to) + " is off the circle of " + text(from));
  }
  Job job = circle_from(width, from, settings);
  job.start.left_x = from.x - to.x;
  job.start.left_y = to.y - from.y;
  // An end that the machine passes would never be reached: the device outside gives up.
  job.clocks = power(width + 2);
  return job;
}

Job circle(int width, std::int64_t radius, const Settings& settings,
           std::optional<std::int64_t> clocks) {
  if (radius < 1) refuse("circle", "R = " + std::to_string(radius) + " is no radius");
  check_fits(width, "circle", "R", radius);
  return until(width, circle_from(width, {radius, 0}, settings), clocks.value_or(turn(width, 1)),
               "circle");
}

Job conic(int width, const Conic& q, Point from, const Settings& settings,
          std::optional<std::int64_t> clocks) {
  check(q);
  check_fits(width, "conic", "2 A", 2 * q.a);
  check_fits(width, "conic", "B", q.b);
  check_fits(width, "conic", "2 C", 2 * q.c);
  check_fits(width, "conic", "X", from.x);
  check_fits(width, "conic", "Y", from.y);
  const Job job = job_of(width, from, rates_at(q, from), q, settings);
  const std::optional<double> root = ellipse_root(q);
  if (!clocks && !root) refuse("conic", "it is no ellipse and has no end: it needs clocks");
  return until(width, job, clocks ? *clocks : turn(width, *root), "conic");
}

}  // namespace cosim::dda
