// What the stimuli of the circular machine must bring about.
#pragma once

#include "model/circular/machine.h"
#include "model/core/bins.h"

namespace cosim::circular {
namespace when {

using At = const Moment<Design>&;

constexpr bool quiet(At m) { return m.in.rst == 0 && m.in.stop == 0; }
constexpr bool idle(At m) { return m.before.t4 == 0; }
constexpr bool finish(At m) { return !idle(m) && m.before.ct7 < 0; }
constexpr bool correction(At m) {
  return !idle(m) && m.before.ct7 >= 0 && m.before.t16 == 0 && m.before.ct8 < 0;
}
constexpr bool sector1(At m) {
  return !idle(m) && m.before.ct7 >= 0 && m.before.t16 == 0 && m.before.ct8 >= 0;
}
constexpr bool sector2(At m) { return !idle(m) && m.before.ct7 >= 0 && m.before.t16 == 1; }
constexpr bool start(At m) { return idle(m) && quiet(m) && m.in.start == 1; }
/// A start whose registers will be these.
constexpr bool start_at(At m, Word t16, Word f, Word ct7, Word ct8) {
  const State<Word>& s = m.after;
  return start(m) && s.t16 == t16 && s.f == f && s.ct7 == ct7 && s.ct8 == ct8;
}
/// A step from X - Y - 1 = `from` to a variant of the sector change.
constexpr bool leaves(At m, Word from, Word to) {
  return sector1(m) && quiet(m) && m.before.ct8 == from && m.after.ct8 == to;
}

}  // namespace when

inline constexpr Bin<Design> bins[] = {
    {"variant -1 by a diagonal step", [](when::At m) { return when::leaves(m, 1, -1); }},
    {"variant -1 by a straight step", [](when::At m) { return when::leaves(m, 0, -1); }},
    {"variant -2", [](when::At m) { return when::leaves(m, 0, -2); }},
    {"start in sector 1", [](when::At m) { return when::start(m) && m.after.t16 == 0; }},
    {"start in sector 2", [](when::At m) { return when::start(m) && m.after.t16 == 1; }},
    {"start at X = Y",
     [](when::At m) {
       return when::start(m) && m.after.t16 == 1 && m.after.ct8 == 0 && m.after.ct7 >= 0;
     }},
    // From (1, 0): F = R - 1.25 = -0.25.
    {"start of R = 1", [](when::At m) { return when::start_at(m, 0, -1, 0, 0); }},
    {"start with nothing loaded", [](when::At m) { return when::start_at(m, 0, 3, 0, 0); }},
    {"start with CT7 < 0", [](when::At m) { return when::start(m) && m.after.ct7 < 0; }},
    {"end of an arc", [](when::At m) { return when::finish(m) && when::quiet(m); }},
    {"stop in sector 1", [](when::At m) { return when::sector1(m) && m.in.stop == 1; }},
    {"stop in sector 2", [](when::At m) { return when::sector2(m) && m.in.stop == 1; }},
    {"stop on the sector change", [](when::At m) { return when::correction(m) && m.in.stop == 1; }},
    {"stop at the end of an arc", [](when::At m) { return when::finish(m) && m.in.stop == 1; }},
    {"stop while idle", [](when::At m) { return when::idle(m) && m.in.stop == 1; }},
    {"load while running", [](when::At m) { return !when::idle(m) && m.in.load == 1; }},
    {"start while running", [](when::At m) { return !when::idle(m) && m.in.start == 1; }},
    {"sector 2 set while running in sector 1",
     [](when::At m) { return when::sector1(m) && m.in.sector2 == 1; }},
    {"load of the other zero",
     [](when::At m) { return when::idle(m) && m.in.load == 1 && m.in.ct7 == ones(m.p.width + 1); }},
    {"reset while idle", [](when::At m) { return when::idle(m) && m.in.rst == 1; }},
    {"reset in sector 1", [](when::At m) { return when::sector1(m) && m.in.rst == 1; }},
    {"reset in sector 2", [](when::At m) { return when::sector2(m) && m.in.rst == 1; }},
    {"reset on the sector change", [](when::At m) { return when::correction(m) && m.in.rst == 1; }},
    {"reset at the end of an arc", [](when::At m) { return when::finish(m) && m.in.rst == 1; }},
};

/// What tb/dut/counts.h finds them by.
constexpr const auto& declared_bins(const Design*) { return bins; }

}  // namespace cosim::circular
