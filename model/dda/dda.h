// Golden model of the interpolator by the method of differential increments, a DDA, written from
// the mathematics: rates, codes and coefficients are signed numbers here.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <cosim/model.h>

#include "model/dda/job.h"
#include "model/dda/view.h"

/// W: bits of an accumulator, 2 to 32: rates are less than 2^W in size.
template <int W>
struct Dda {
  using Number = Int<W + 1>;  // wraps

  struct In {
    Bit rst;                // clear every register
    Bit write;              // take data while idle
    UInt<4> address;        // the register to write, see wait()
    Hex<UInt<W + 1>> data;  // what is written
    Bit start;              // start, while idle
    Bit stop;               // stop, no step
  };
  struct Out {
    Bit busy;       // a curve is being drawn
    Bit x_up;       // X + 1 on this clock: a carry of SX
    Bit x_down;     // X - 1 on this clock: a borrow of SX
    Bit y_up;       // Y + 1 on this clock
    Bit y_down;     // Y - 1 on this clock
    Number code_x;  // X before this clock's step
    Number code_y;  // Y before this clock's step
  };
  static constexpr const char* source = "the method of differential increments";
  static constexpr auto reset = active_high<&In::rst>;
  static constexpr std::string_view register_suffix = "_q";

  Bit running = 0;                   // a curve is being drawn
  Bit sequential = 0;                // Y's rate follows the step of X at once
  Bit normalise = 0;                 // shift the rates up before the first step
  Bit free = 0;                      // no count of steps: run until a stop
  Source<"SX", UInt<W>> sx = 0;      // accumulator of X
  Source<"SY", UInt<W>> sy = 0;      // accumulator of Y
  Source<"P1", Number> rate_x = 0;   // x' = -(B x + 2 C y + E)
  Source<"P2", Number> rate_y = 0;   // y' = 2 A x + B y + D
  Source<"P3", Number> x = 0;        // the point
  Source<"P4", Number> y = 0;        //
  Source<"P5", UInt<W>> left_x = 0;  // steps of X left
  Source<"P6", UInt<W>> left_y = 0;  // steps of Y left
  Number two_a = 0;                  // 2 A: by which a step of X changes Y's rate
  Number b = 0;                      // B: by which a step changes its own rate
  Number two_c = 0;                  // 2 C: by which a step of Y changes X's rate

  Out clock(const In& in) {
    const Bit over = in.stop || is_done();
    const Bit shift = is_to_shift();
    const Bit step = running && !over && !shift;
    Dda next = *this;
    const Move move = next.advance();
    const Out out{.busy = running,
                  .x_up = step && move.x.up,
                  .x_down = step && move.x.down,
                  .y_up = step && move.y.up,
                  .y_down = step && move.y.down,
                  .code_x = Number(x),
                  .code_y = Number(y)};
    if (in.rst) {
      *this = Dda{};
    } else if (!running) {
      wait(in);
    } else if (over) {
      running = false;
    } else if (shift) {
      rate_x = rate_x + rate_x;
      rate_y = rate_y + rate_y;
    } else {
      *this = next;
    }
    return out;
  }

  Bit is_done() const { return !free && left_x == 0 && left_y == 0; }
  /// Neither rate has half of the accumulator or more.
  Bit is_to_shift() const { return normalise && !is_full(rate_x) && !is_full(rate_y); }
  static Bit is_full(const Number& rate) {
    const UInt<W> half = UInt<W>(1) << (W - 1);
    return rate >= half || rate <= -half;
  }

  /// A step of one axis: a carry or a borrow of its accumulator, not both.
  struct Increment {
    Bit up, down;

    /// The number by which a step up changes something, for the step that there is.
    Number times(const Number& by) const { return mux(up, by, mux(down, -by, Number(0))); }
  };
  struct Move {
    Increment x, y;
  };
  template <class Sum>
  static Increment increment(const Sum& sum, const Bit& may_step) {
    const Bit carry = sum > UInt<W>(-1), borrow = sum < 0;
    return {.up = may_step && carry, .down = may_step && borrow};
  }

  /// The rates are added, and the steps that come of it change them.
  Move advance() {
    const auto sum_x = sx + rate_x;
    const Increment dx = increment(sum_x, free || left_x != 0);
    const Number turned = rate_y + dx.times(two_a);
    const auto sum_y = sy + mux(sequential, turned, rate_y);
    const Increment dy = increment(sum_y, free || left_y != 0);
    sx = sum_x;
    sy = sum_y;
    rate_x = rate_x - dx.times(b) - dy.times(two_c);
    rate_y = turned + dy.times(b);
    x = x + dx.up - dx.down;
    y = y + dy.up - dy.down;
    left_x = left_x - (!free && (dx.up || dx.down));
    left_y = left_y - (!free && (dy.up || dy.down));
    return {dx, dy};
  }

  /// A clock on which no curve is drawn.
  void wait(const In& in) {
    const auto take = [&](int address, auto& to, const auto& data) {
      to = mux(in.write && in.address == address, data, to);
    };
    take(0, sequential, in.data[0]);
    take(0, normalise, in.data[1]);
    take(0, free, in.data[2]);
    take(1, sx, in.data);
    take(2, sy, in.data);
    take(3, rate_x, in.data);
    take(4, rate_y, in.data);
    take(5, x, in.data);
    take(6, y, in.data);
    take(7, left_x, in.data);
    take(8, left_y, in.data);
    take(9, two_a, in.data);
    take(10, b, in.data);
    take(11, two_c, in.data);
    running = in.start && !in.stop;
  }

  /// Each must be possible, and must happen under the stimuli.
  auto cases(const In& in) const {
    const Bit resets = in.rst, stop = in.stop && !in.rst, quiet = !in.rst && !in.stop;
    const Bit idle = !in.rst && !running, waits = idle && !in.stop;
    const Bit done = running && is_done(), curved = two_a != 0 || two_c != 0;
    const Bit shift = running && !done && is_to_shift();
    const Bit draws = quiet && running && !done && !shift;
    Dda next = *this;
    const Move move = next.advance();
    const Bit step_x = draws && (move.x.up || move.x.down);
    const Bit step_y = draws && (move.y.up || move.y.down);
    const Bit turns = step_x && two_a != 0;
    const Bit carries = increment(sx + rate_x, 1).up;
    const Number half = UInt<W>(1) << (W - 1);
    return stated({{"reset while idle", resets && !running},
                   {"reset while running", resets && running},
                   {"stop of a free curve", stop && running && free},
                   {"stop of a counted curve", stop && running && !free},
                   {"stop on the shift", stop && shift},
                   {"stop at the end", stop && done},
                   {"write", waits && in.write && !in.start},
                   {"write and start at once", waits && in.write && in.start},
                   {"write where no register is", idle && in.write && in.address > 11},
                   {"start and stop at once", idle && in.start && in.stop},
                   {"start with nothing written", idle && in.start && rate_x == 0 && rate_y == 0},
                   {"write while running", quiet && running && in.write},
                   {"start while running", quiet && running && in.start},
                   {"shift of the rates", quiet && shift},
                   {"shift of a line with a rate below 0", quiet && shift && rate_x < 0},
                   {"rate of half of the accumulator, backwards", draws && rate_x == -half},
                   {"rate of 2^W, backwards", draws && rate_x == -half - half},
                   {"step of X up", draws && move.x.up},
                   {"step of X down", draws && move.x.down},
                   {"step of Y up", draws && move.y.up},
                   {"step of Y down", draws && move.y.down},
                   {"steps of both on a clock", step_x && step_y},
                   {"clock with no step", draws && !step_x && !step_y},
                   {"step of X before Y's rate is added", turns && sequential},
                   {"step of X behind Y's rate", turns && !sequential},
                   {"B turns a rate", step_x && b != 0},
                   {"carry of an axis that is done", draws && !free && left_x == 0 && carries},
                   {"end of a line", quiet && done && !curved},
                   {"end of a circle", quiet && done && curved}});
  }

  // What it is given to do is a curve (curve.h); a job is what driver and checker see of one.
  using Work = cosim::dda::Job;
  static constexpr std::uint64_t most_clocks = std::uint64_t{1} << 40;  // no job waits for ever

  static constexpr int addresses = 12;  // of the modes, and of every register behind them
  using Clocks = UInt<std::max(W + 4, 29)>;
  struct Job {
    Array<UInt<W + 1>, addresses> words;  // what is written, by address
    Bit counted;                          // stop it after so many clocks
    Clocks clocks;
  };
  static Job job_of(const Work& work) {
    const auto& s = work.start;
    return {.words = {s.sequential + 2 * s.normalise + 4 * s.free, s.sx, s.sy, s.rate_x, s.rate_y,
                      s.x, s.y, s.left_x, s.left_y, s.two_a, s.b, s.two_c},
            .counted = work.clocks.has_value(),
            .clocks = work.clocks.value_or(0)};
  }
  static std::vector<Work> smaller(const Work& work) { return cosim::dda::smaller(work); }
  static std::string describe(const Work& work) { return cosim::dda::describe(work); }

  /// It writes the registers for a curve, starts it, and waits for its end or stops it: twelve
  /// clocks to write and start, those it runs, and one or two to end.
  struct Driver {
    UInt<4> written = 0;  // addresses that were written
    Clocks running = 0;   // clocks of running so far

    In drive(const Job& job, In in) const {
      if (written < addresses) {
        in.write = 1;
        in.address = written;
        in.data = job.words[written];
        in.start = written == addresses - 1;
      } else {
        in.stop = job.counted && running >= job.clocks;
      }
      return in;
    }
    /// The start shows in `busy` on the next clock.
    Bit driven(const Job&, const Out& out) {
      const Bit writes = written < addresses, over = !writes && !out.busy;
      written = written + writes;
      running = mux(writes || over, 0, running + 1);
      return over;
    }
  };

  /// The rates of the point that it is on, as Track of oracle.h has them, and the left side of the
  /// curve's equation there. Nothing wraps on the way of a job that is one.
  struct Checker {
    /// A turn that drifts may add 2 A to it on each of its clocks.
    using Excess = Int<std::min(2 * W + 4, W + 16)>;
    UInt<6> shifts = 0;     // clocks to come that shift
    Clocks left = 0;        // clocks to come until the stop
    Bit over = 0;           // it has come to the end
    UInt<W> sum_x = 0;      // the sum of the rates, its part of a step
    UInt<W> sum_y = 0;      //
    Int<W + 2> rate_x = 0;  // at the point
    Int<W + 2> rate_y = 0;  //
    Int<W + 2> x = 0;       // the point
    Int<W + 2> y = 0;       //
    UInt<W> left_x = 0;     // steps to come
    UInt<W> left_y = 0;     //
    Excess excess = 0;      // twice the equation's left side, shifted
    UInt<W + 4> steps = 0;  // clocks with a step so far, of a line or an arc
    Excess least = 0;       // excess of this job
    Excess most = 0;        //

    /// Wrong is a step, a code or the end.
    Bit checked(const Job& job, const Driver&, const Out& out, const Bit& is_last) {
      const Bit at_once = job.words[0][0], counted = !job.words[0][2];  // sequential, not free
      const Number by_x = job.words[9], by_own = job.words[10], by_y = job.words[11];
      const Bit ended = (counted && left_x == 0 && left_y == 0) || (job.counted && left == 0);
      const Bit draws = out.busy && !ended, shift = draws && shifts != 0, moves = draws && !shift;

      const auto to_x = sum_x + rate_x;
      const Step dx = step_to(to_x, moves && (!counted || left_x != 0));
      const Int<W + 2> turned_x = rate_x - times(dx, by_own), turned_y = rate_y + times(dx, by_x);
      const auto to_y = sum_y + mux(at_once, turned_y, rate_y);
      const Step dy = step_to(to_y, moves && (!counted || left_y != 0));
      const Int<W + 2> next_x = turned_x - times(dy, by_y);
      const Bit right = out.x_up - out.x_down == dx && out.y_up - out.y_down == dy &&
                        out.code_x == x && out.code_y == y;

      // A step changes the left side by y' at its middle along x, by -x' along y.
      excess = excess + times(dx, rate_y + turned_y) - times(dy, turned_x + next_x);
      least = mux(excess < least, excess, least);
      most = mux(excess > most, excess, most);
      steps = steps + (dx != 0 || dy != 0);
      rate_x = mux(shift, rate_x + rate_x, next_x);
      rate_y = mux(shift, rate_y + rate_y, turned_y + times(dy, by_own));
      sum_x = mux(moves, UInt<W>(to_x), sum_x);
      sum_y = mux(moves, UInt<W>(to_y), sum_y);
      x = x + dx;
      y = y + dy;
      left_x = left_x - (dx != 0);
      left_y = left_y - (dy != 0);
      shifts = shifts - shift;
      left = left - (out.busy && left != 0);
      over = mux(out.busy, ended, over);
      return (out.busy && !right) || (is_last && !over);
    }

   private:
    using Step = Int<2>;  // -1 to 1
    template <class Sum>
    static Step step_to(const Sum& sum, const Bit& may_step) {
      return mux(may_step, sum >> W, 0);
    }
    template <class Of>
    static auto times(const Step& step, const Of& by) {
      return mux(step == 0, 0, mux(step < 0, -by, by));
    }
  };
  static Checker checker_of(const Work& work) {
    const auto& s = work.start;
    return {.shifts = cosim::dda::shifts_of(W, work),
            .left = work.clocks.value_or(0),
            .sum_x = s.sx,
            .sum_y = s.sy,
            .rate_x = s.rate_x,
            .rate_y = s.rate_y,
            .x = s.x,
            .y = s.y,
            .left_x = s.left_x,
            .left_y = s.left_y};
  }

  /// Calls take(dx, dy) for the step of a clock, where there is one.
  template <class Take>
  static void for_each_step(const Out& out, const Take& take) {
    const int dx = int(out.x_up) - int(out.x_down), dy = int(out.y_up) - int(out.y_down);
    if (dx != 0 || dy != 0) take(dx, dy);
  }
  using View = cosim::dda::View;
};
