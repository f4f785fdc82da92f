// Golden model of the circular interpolator, SU 1665343, written from the mathematics: F, CT7 and
// CT8 are numbers here, and their registers hold the codes.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <cosim/model.h>

#include "model/circular/job.h"
#include "model/circular/view.h"

/// W: bits of a coordinate, 2 to 32: arcs with round(R) < 2^W.
template <int W>
struct Circular {
  using Counter = OnesComplement<W + 1>;
  using CounterCode = OnesComplementCode<W + 1>;

  struct In {
    Bit rst;                        // clear everything
    Bit load;                       // take f, ct7, ct8 while idle
    Source<"29", Int<W + 2>> f;     // floor of F at the start
    Source<"30", CounterCode> ct7;  // Y in sector 1, X - 1 in sector 2
    Source<"31", CounterCode> ct8;  // X - Y - 1 in sector 1, X - Y in sector 2
    Source<"34", Bit> sector2;      // start in sector 2, while idle
    Source<"33", Bit> start;        // start, while idle
    Source<"32", Bit> stop;         // end of work: clear everything, no step
  };
  struct Out {
    Source<"4", Bit> running;  // an arc is being drawn
    Source<"35", Bit> step_y;  // Y + 1 on this clock
    Source<"36", Bit> step_x;  // X - 1 on this clock
  };
  static constexpr const char* source = "SU 1665343";
  static constexpr auto reset = active_high<&In::rst>;
  static constexpr std::string_view register_suffix = "_q";

  using Function = OnesComplement<W + 4, true>;
  Source<"4", Bit> t4 = 0;                   // running
  Source<"16", Bit> t16 = 0;                 // sector 2
  Source<"1", Fraction<2, Function>> f = 3;  // evaluation function F, in quarters
  Source<"7", Counter> ct7 = 0;              // Y in sector 1, X - 1 in sector 2
  Source<"8", Counter> ct8 = 0;              // X - Y - 1 in sector 1, X - Y in sector 2

  Out clock(const In& in) {
    const Bit finish = is_over(), correct = is_past_sector1();
    const Bit step = t4 && !finish && !correct && !in.stop;
    // The inner candidate is next where the midpoint is outside: that is the diagonal step in
    // sector 1, the straight one in sector 2.
    const Bit diagonal = t16 == is_midpoint_inside();
    const Out out{
        .running = t4, .step_y = step && (diagonal || !t16), .step_x = step && (diagonal || t16)};
    if (in.rst || in.stop || finish) {
      *this = Circular{};
    } else if (!t4) {
      wait(in);
    } else if (correct) {
      pass_into_sector2();
    } else {
      advance(diagonal);
    }
    return out;
  }

  /// X is below 0.
  Bit is_over() const { return t4 && ct7 < 0; }
  /// The last step left sector 1: to X = Y (variant -1), or X = Y - 1 (-2). Whatever else a load
  /// has put into CT8 counts as the one of its parity.
  Bit is_past_sector1() const { return t4 && !t16 && ct8 < 0; }
  Bit is_variant1() const { return ct8[0]; }
  /// F is the midpoint test of the next two candidates; negative: it is outside the circle.
  Bit is_midpoint_inside() const { return f > 0; }

  /// A clock on which no arc runs.
  void wait(const In& in) {
    if (in.load) {
      f = (in.f << 2) + 3;  // its fraction is wired
      ct7 = in.ct7.number();
      ct8 = in.ct8.number();
    }
    t4 = in.start;
    t16 = t16 || in.sector2;
  }

  /// The correction: F gains X + Y, CT7 passes from Y to X - 1, CT8 from X - Y - 1 to X - Y.
  void pass_into_sector2() {
    const Bit level = is_variant1();
    const Int<W + 2> x = ct7 - !level;
    f = f + ((x + x + !level) << 2);
    ct7 = x - 1;
    ct8 = mux(level, 0, -1);
    t16 = 1;
  }

  /// A step. F gains 2(X' - Y') - 1 on a diagonal one; 2X' - 1 or -(2Y' + 1) on a straight one.
  /// Where a loaded value has gone out of range the codes give the other numbers.
  void advance(const Bit& diagonal) {
    ct7 = mux(t16, ct7 - 1, ct7 + 1);
    ct8 = ct8 - mux(diagonal, 2, 1);
    const auto twice7 = ct7 + ct7, twice8 = ct8 + ct8;
    Int<W + 3> gain = 0;
    merge(gain, [&] {
      if (diagonal && !t16) {
        gain = twice8 + 1;
      } else if (diagonal) {
        gain = twice8 - (ct8 < 0);
      } else if (t16) {
        gain = twice7 + 1;
      } else {
        gain = -(twice7 + (ct7 >= 0));
      }
    });
    f = f + (gain << 2);
  }

  /// Each must be possible, and must happen under the stimuli.
  auto cases(const In& in) const {
    const Bit resets = in.rst, stop = in.stop && !in.rst, quiet = !in.rst && !in.stop;
    const Bit end = is_over(), past = !end && is_past_sector1();
    const Bit sector1 = t4 && !end && !t16 && !past, sector2 = t4 && !end && t16;
    const Bit inside = is_midpoint_inside();
    const Bit waits = quiet && !t4, begins = waits && in.start;
    Circular first = *this;
    merge(first, [&] { first.wait(in); });
    const Bit level = first.ct8 == 0;
    const Bit from0 = begins && !first.t16 && first.ct7 == 0 && level;
    const Bit ones = reduce_and(in.ct7);
    return stated({{"reset while idle", resets && !t4},
                   {"reset in sector 1", resets && sector1},
                   {"reset in sector 2", resets && sector2},
                   {"reset on the sector change", resets && past},
                   {"reset at the end of an arc", resets && end},
                   {"stop while idle", stop && !t4},
                   {"stop in sector 1", stop && sector1},
                   {"stop in sector 2", stop && sector2},
                   {"stop on the sector change", stop && past},
                   {"stop at the end of an arc", stop && end},
                   {"load", waits && in.load && !in.start},
                   {"load and start at once", begins && in.load},
                   {"load of the other zero", waits && in.load && ones},
                   {"start in sector 1", begins && !first.t16},
                   {"start in sector 2", begins && first.t16},
                   {"start with sector 2 set at once", begins && in.sector2},
                   {"start at X = Y", begins && first.t16 && level && first.ct7 >= 0},
                   {"start of R = 1", from0 && first.f == -1},  // from (1, 0): F = R - 1.25 = -0.25
                   {"start with nothing loaded", from0 && first.f == 3},
                   {"start with CT7 < 0", begins && first.ct7 < 0},
                   {"load while running", quiet && t4 && in.load},
                   {"start while running", quiet && t4 && in.start},
                   {"sector 2 set while running in sector 1", quiet && sector1 && in.sector2},
                   {"straight step in sector 1", quiet && sector1 && inside},
                   {"diagonal step in sector 1", quiet && sector1 && !inside},
                   {"into variant -1 by a straight step", quiet && sector1 && inside && ct8 == 0},
                   {"into variant -1 by a diagonal step", quiet && sector1 && !inside && ct8 == 1},
                   {"into variant -2", quiet && sector1 && !inside && ct8 == 0},
                   {"variant -1", quiet && past && is_variant1()},
                   {"variant -2", quiet && past && !is_variant1()},
                   {"straight step in sector 2", quiet && sector2 && !inside},
                   {"diagonal step in sector 2", quiet && sector2 && inside},
                   {"the end of an arc", quiet && end}});
  }

  /// True of every state after a reset, and no matter to RTL and model: what a mutant may rest on.
  auto reached() const {
    return stated({{"F has a fraction of 3/4 while no arc runs", t4 || (f[0] && f[1])}});
  }

  // What it is given to do is an arc (arc.h); a job is what driver and checker see of one.
  using Work = cosim::circular::Arc;
  static constexpr std::uint64_t most_clocks = std::uint64_t{1} << 40;  // no arc waits for ever

  struct Job {
    Bit sector2;        // start in sector 2
    Int<W + 2> f;       // the words to load
    Int<W + 1> ct7;     //
    Int<W + 1> ct8;     //
    Bit counted;        // end it after so many steps
    UInt<W + 2> count;  // which no arc has more of
  };
  static Job job_of(const Work& arc) {
    const auto s = cosim::circular::setup(arc.from, arc.radius2);
    constexpr auto most = (std::int64_t{1} << (W + 2)) - 1;
    return {.sector2 = s.sector2,
            .f = s.f,
            .ct7 = s.ct7,
            .ct8 = s.ct8,
            .counted = arc.count.has_value(),
            .count = std::min(arc.count.value_or(0), most)};
  }
  static std::vector<Work> smaller(const Work& arc) { return cosim::circular::smaller(arc); }
  static std::string describe(const Work& arc) { return cosim::circular::describe(arc); }

  /// It loads an arc, starts it, and waits for its end or stops it: one clock to load and start,
  /// then one a step, one more for a sector change and one or two to end.
  struct Driver {
    Bit begun = 0;          // the arc was started
    UInt<W + 2> steps = 0;  // steps so far

    In drive(const Job& job, In in) const {
      if (begun) {
        in.stop = job.counted && steps >= job.count;
      } else {
        in.load = in.start = 1;
        in.sector2 = job.sector2;
        in.f = job.f;
        in.ct7 = Counter(job.ct7).code();
        in.ct8 = Counter(job.ct8).code();
      }
      return in;
    }
    Bit driven(const Job&, const Out& out) {
      const Bit over = begun && !out.running;
      steps = mux(begun, steps + (out.step_y || out.step_x), 0);
      begun = 1;
      return over;
    }
  };

  /// Which of the two points in reach is nearest to the circle, from the steps alone. It knows
  /// x^2 + y^2 - R^2 of the point that it is on. A step changes that by less than 2^(W + 2), and
  /// before it was less than 2^W: it is right up to the first step that is not.
  struct Checker {
    Bit whole = 0;          // the steps lead to the end of the arc
    UInt<W + 1> end_y = 0;  // where x is 0
    Int<W + 2> x1 = 0;      // the point: x - 1
    UInt<W + 1> y = 0;
    Int<W + 4> excess = 0;  // x^2 + y^2 - R^2
    UInt<W + 2> steps = 0;  // of the arc
    Int<W + 4> least = 0;   // excess of this arc
    Int<W + 4> most = 0;

    /// Wrong is a step, the number of them or the last point.
    Bit checked(const Job&, const Driver& driver, const Out& out, const Bit& over) {
      const Bit up = out.step_y, left = out.step_x, any = up || left;
      const Bit sector1 = x1 >= y, past = !sector1 && x1 < 0;
      excess = excess + mux(up, y + y + 1, 0) - mux(left, x1 + x1 + 1, 0);
      x1 = x1 - left;
      y = y + up;
      least = mux(excess < least, excess, least);
      most = mux(excess > most, excess, most);
      const Bit at_end = x1 == -1 && y == end_y;
      const Bit ended = driver.steps == steps && (at_end || !whole) && !any;
      // In sector 1 each step goes up, and left where the circle is nearer to x - 1 on that row:
      // x^2 + y^2 - R^2 of the point that it comes to is less than x where it did not go left, else
      // it is -x or more. In sector 2 the same holds of y: each step goes left, and up or not.
      const Bit must = mux(sector1, up, left), outer = mux(sector1, !left, up);
      const auto resting = mux(sector1, x1 + 1, y);
      const Bit nearest = mux(outer, excess < resting, excess >= -resting);
      return (any && (past || !must || !nearest)) || (over && !ended);
    }
  };
  static Checker checker_of(const Work& arc) {
    const auto due = cosim::circular::due_of(arc);
    return {.whole = due.is_whole,
            .end_y = due.end_y,
            .x1 = arc.from.x - 1,
            .y = arc.from.y,
            .excess = due.excess,
            .steps = due.steps,
            .least = due.excess,
            .most = due.excess};
  }

  /// Calls take(dx, dy) for the step of a clock, where there is one.
  template <class Take>
  static void for_each_step(const Out& out, const Take& take) {
    if (out.step_x || out.step_y) take(-int(out.step_x), int(out.step_y));
  }
  using View = cosim::circular::View;
};
