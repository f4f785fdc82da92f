// What the stimuli of the DDA must bring about.
#pragma once

#include "model/core/bins.h"
#include "model/dda/machine.h"

namespace cosim::dda {
namespace when {

using At = const Moment<Design>&;

constexpr bool quiet(At m) { return m.in.rst == 0 && m.in.stop == 0; }
constexpr bool idle(At m) { return m.before.running == 0; }
constexpr bool done(At m) {
  return !idle(m) && m.before.free == 0 && m.before.left_x == 0 && m.before.left_y == 0;
}
constexpr bool shift(At m) {
  return !idle(m) && !done(m) && m.before.normalise == 1 && !is_full(m.p, m.before.rate_x) &&
         !is_full(m.p, m.before.rate_y);
}
constexpr bool add(At m) { return !idle(m) && !done(m) && !shift(m) && quiet(m); }
constexpr bool x_steps(At m) { return (m.out.x_up | m.out.x_down) != 0; }
constexpr bool y_steps(At m) { return (m.out.y_up | m.out.y_down) != 0; }
constexpr bool curved(At m) { return (m.before.two_a | m.before.two_c) != 0; }

}  // namespace when

inline constexpr Bin<Design> bins[] = {
    {"step of X up", [](when::At m) { return m.out.x_up == 1; }},
    {"step of X down", [](when::At m) { return m.out.x_down == 1; }},
    {"step of Y up", [](when::At m) { return m.out.y_up == 1; }},
    {"step of Y down", [](when::At m) { return m.out.y_down == 1; }},
    {"steps of both on a clock", [](when::At m) { return when::x_steps(m) && when::y_steps(m); }},
    {"clock with no step",
     [](when::At m) { return when::add(m) && !when::x_steps(m) && !when::y_steps(m); }},
    {"step of X before Y's rate is added",
     [](when::At m) {
       return m.before.sequential == 1 && when::x_steps(m) && m.before.two_a != 0;
     }},
    {"step of X behind Y's rate",
     [](when::At m) {
       return m.before.sequential == 0 && when::x_steps(m) && m.before.two_a != 0;
     }},
    {"B turns a rate", [](when::At m) { return when::x_steps(m) && m.before.b != 0; }},
    {"carry of an axis that is done",
     [](when::At m) {
       return when::add(m) && m.before.free == 0 && m.before.left_x == 0 &&
              m.before.sx + m.before.rate_x >= shift_left(1, m.p.width);
     }},
    {"shift of the rates", [](when::At m) { return when::shift(m) && when::quiet(m); }},
    {"shift of a line with a rate below 0",
     [](when::At m) { return when::shift(m) && when::quiet(m) && m.before.rate_x < 0; }},
    {"rate of half of the accumulator, backwards",
     [](when::At m) { return m.before.rate_x == -shift_left(1, m.p.width - 1) && when::add(m); }},
    {"rate of 2^W, backwards",
     [](when::At m) { return m.before.rate_x == -shift_left(1, m.p.width) && when::add(m); }},
    {"end of a line",
     [](when::At m) { return when::done(m) && !when::curved(m) && when::quiet(m); }},
    {"end of a circle",
     [](when::At m) { return when::done(m) && when::curved(m) && when::quiet(m); }},
    {"stop of a free curve",
     [](when::At m) { return !when::idle(m) && m.before.free == 1 && m.in.stop == 1; }},
    {"stop of a counted curve",
     [](when::At m) { return !when::idle(m) && m.before.free == 0 && m.in.stop == 1; }},
    {"stop on the shift", [](when::At m) { return when::shift(m) && m.in.stop == 1; }},
    {"stop at the end", [](when::At m) { return when::done(m) && m.in.stop == 1; }},
    {"start and stop at once",
     [](when::At m) { return when::idle(m) && m.in.start == 1 && m.in.stop == 1; }},
    {"start with nothing written",
     [](when::At m) {
       return when::idle(m) && m.in.start == 1 && m.before.rate_x == 0 && m.before.rate_y == 0;
     }},
    {"write and start on one clock",
     [](when::At m) { return when::idle(m) && m.in.write == 1 && m.in.start == 1; }},
    {"write where no register is",
     [](when::At m) { return when::idle(m) && m.in.write == 1 && m.in.address > 11; }},
    {"write while running", [](when::At m) { return !when::idle(m) && m.in.write == 1; }},
    {"start while running", [](when::At m) { return !when::idle(m) && m.in.start == 1; }},
    {"reset while idle", [](when::At m) { return when::idle(m) && m.in.rst == 1; }},
    {"reset while running", [](when::At m) { return !when::idle(m) && m.in.rst == 1; }},
};

/// What tb/dut/counts.h finds them by.
constexpr const auto& declared_bins(const Design*) { return bins; }

}  // namespace cosim::dda
