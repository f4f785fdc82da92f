// What is true of the DDA's state at all times, and what must happen on a clock of it.
#pragma once

#include <array>

#include "model/core/stated.h"
#include "model/dda/machine.h"

namespace cosim::dda {

// There is no invariant: RTL and model stay equal from every state that registers() can encode.

/// Each must be possible, and must happen under the stimuli.
template <class V>
constexpr auto cases(const Params& p, const State<V>& s, const Inputs<V>& in) {
  using Flag = Condition<V>;
  const Flag reset = is_set(in.rst);
  const Flag stop = !reset & is_set(in.stop);
  const Flag quiet = !(reset | is_set(in.stop));
  const Flag running = is_set(s.running);
  const Flag idle = !reset & !running;
  const Flag free = is_set(s.free);
  const Flag none_x = s.left_x == V(0);
  const Flag done = running & !free & none_x & (s.left_y == V(0));
  const Flag curved = !(s.two_a == V(0)) | !(s.two_c == V(0));
  const Flag full = is_full(p, s.rate_x) | is_full(p, s.rate_y);
  const Flag shift = running & !done & is_set(s.normalise) & !full;
  const Flag draws = quiet & running & !done & !shift;
  const Advance<V> a = advanced(p, s);
  const Flag x_up = draws & is_set(a.x.up);
  const Flag x_down = draws & is_set(a.x.down);
  const Flag y_up = draws & is_set(a.y.up);
  const Flag y_down = draws & is_set(a.y.down);
  const Flag step_x = x_up | x_down;
  const Flag step_y = y_up | y_down;
  const Flag turns = step_x & !(s.two_a == V(0));
  const Flag write = is_set(in.write);
  const Flag start = is_set(in.start);
  return std::array<Stated<V>, 29>{
      {{"reset while idle", reset & !running},
       {"reset while running", reset & running},
       {"stop of a free curve", stop & running & free},
       {"stop of a counted curve", stop & running & !free},
       {"stop on the shift", stop & shift},
       {"stop at the end", stop & done},
       {"write", idle & quiet & write & !start},
       {"write and start at once", idle & quiet & write & start},
       {"write where no register is", idle & write & (in.address > V(11))},
       {"start and stop at once", idle & start & stop},
       {"start with nothing written", idle & start & (s.rate_x == V(0)) & (s.rate_y == V(0))},
       {"write while running", quiet & running & write},
       {"start while running", quiet & running & start},
       {"shift of the rates", quiet & shift},
       {"shift of a line with a rate below 0", quiet & shift & (s.rate_x < V(0))},
       {"rate of half of the accumulator, backwards",
        draws & (s.rate_x == V(-shift_left(1, p.width - 1)))},
       {"rate of 2^W, backwards", draws & (s.rate_x == V(-shift_left(1, p.width)))},
       {"step of X up", x_up},
       {"step of X down", x_down},
       {"step of Y up", y_up},
       {"step of Y down", y_down},
       {"steps of both on a clock", step_x & step_y},
       {"clock with no step", draws & !step_x & !step_y},
       {"step of X before Y's rate is added", turns & is_set(s.sequential)},
       {"step of X behind Y's rate", turns & !is_set(s.sequential)},
       {"B turns a rate", step_x & !(s.b == V(0))},
       {"carry of an axis that is done",
        draws & !free & none_x & !(s.sx + s.rate_x < V(shift_left(1, p.width)))},
       {"end of a line", quiet & done & !curved},
       {"end of a circle", quiet & done & curved}}};
}

}  // namespace cosim::dda
