// What the stimuli of the linear machine must bring about.
#pragma once

#include "model/core/bins.h"
#include "model/linear/machine.h"

namespace cosim::linear {
namespace when {

using At = const Moment<Design>&;

constexpr bool quiet(At m) { return m.in.reset == 0 && m.in.initial_set_n == 1; }
constexpr bool idle(At m) { return m.before.running == 0; }
constexpr bool waiting(At m) { return idle(m) && m.before.coded == 1; }
constexpr bool forming(At m) { return !idle(m) && m.before.formed == 0; }
constexpr bool strobe(At m) { return m.before.formed == 1; }
constexpr bool last_word(At m) { return strobe(m) && m.before.left <= m.p.word(); }
/// A line begins: its BP is `before.left`.
constexpr bool start(At m) { return idle(m) && quiet(m) && m.after.running == 1; }
constexpr bool start_of(At m, Word low_code, Word pattern) {
  return start(m) && m.before.low_code == low_code && m.before.pattern == pattern;
}
constexpr bool writes_uk(At m) {
  return idle(m) && quiet(m) && m.in.write_bp == 0 && m.in.write_uk == 1;
}

}  // namespace when

inline constexpr Bin<Design> bins[] = {
    {"BP a multiple of 2^gamma",
     [](when::At m) {
       return when::start(m) && m.before.left != 0 && low_bits(m.before.left, m.p.gamma()) == 0;
     }},
    {"BP no multiple of 2^gamma",
     [](when::At m) { return when::start(m) && low_bits(m.before.left, m.p.gamma()) != 0; }},
    {"BP = 0", [](when::At m) { return when::start(m) && m.before.left == 0; }},
    {"BP = 1", [](when::At m) { return when::start(m) && m.before.left == 1; }},
    {"BP = 2^m - 1", [](when::At m) { return when::start(m) && m.before.left == ones(m.p.m); }},
    {"counter 4 at 2^n",
     [](when::At m) {
       return when::start(m) && registers(m.p, m.before).counter4 == shift_left(1, m.p.n);
     }},
    {"UK all zeros", [](when::At m) { return when::start_of(m, 0, 0); }},
    {"UK all ones",
     [](when::At m) { return when::start_of(m, ones(m.p.n), ones(m.p.word() - 1)); }},
    {"end of a line", [](when::At m) { return when::last_word(m) && when::quiet(m); }},
    {"end of a line of no words",
     [](when::At m) { return when::forming(m) && when::quiet(m) && m.after.running == 0; }},
    {"UK written twice", [](when::At m) { return when::writes_uk(m) && m.before.coded == 1; }},
    {"UK written with no new BP",
     [](when::At m) { return when::writes_uk(m) && m.before.coded == 0 && m.before.left == 0; }},
    {"BP and UK written at once",
     [](when::At m) { return when::idle(m) && m.in.write_bp == 1 && m.in.write_uk == 1; }},
    {"start on the clock of a write",
     [](when::At m) { return when::waiting(m) && m.in.start == 1 && m.in.write_uk == 1; }},
    {"start with no code",
     [](when::At m) { return when::idle(m) && m.before.coded == 0 && m.in.start == 1; }},
    {"BP written while running", [](when::At m) { return !when::idle(m) && m.in.write_bp == 1; }},
    {"UK written while running", [](when::At m) { return !when::idle(m) && m.in.write_uk == 1; }},
    {"start while running", [](when::At m) { return !when::idle(m) && m.in.start == 1; }},
    {"initial set while idle", [](when::At m) { return when::idle(m) && m.in.initial_set_n == 0; }},
    {"initial set before the first word",
     [](when::At m) { return when::forming(m) && m.in.initial_set_n == 0; }},
    {"initial set between words",
     [](when::At m) { return when::strobe(m) && !when::last_word(m) && m.in.initial_set_n == 0; }},
    {"initial set on the last word",
     [](when::At m) { return when::last_word(m) && m.in.initial_set_n == 0; }},
    {"reset with no code",
     [](when::At m) { return when::idle(m) && m.before.coded == 0 && m.in.reset == 1; }},
    {"reset with a code", [](when::At m) { return when::waiting(m) && m.in.reset == 1; }},
    {"reset before the first word", [](when::At m) { return when::forming(m) && m.in.reset == 1; }},
    {"reset between words",
     [](when::At m) { return when::strobe(m) && !when::last_word(m) && m.in.reset == 1; }},
    {"reset on the last word", [](when::At m) { return when::last_word(m) && m.in.reset == 1; }},
};

/// What tb/dut/counts.h finds them by.
constexpr const auto& declared_bins(const Design*) { return bins; }

}  // namespace cosim::linear
