// Golden model of unsynced.sv, with its fault too.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Unsynced {
  struct In {
    Rises a_clk;                      // the clock of the level
    Bit a_rst_n;                      // 0 resets the level, at once
    Bit turn;                         // it changes
    Rises b_clk;                      // the clock of what follows it
    Bit b_rst;                        // resets that, at once
    Sampled<"first", Bit> first_new;  // first takes the new value
    Sampled<"idle", Bit> idle_new;    // idle does
    Sampled<"busy", Bit> busy_new;    // busy does
  };
  struct Out {
    Bit works;  // it is busy
  };
  static constexpr auto reset = both(active_low<&In::a_rst_n>, active_high<&In::b_rst>);

  Bit level = 0;
  Bit first = 0;   // the level, sampled
  Bit second = 0;  // the same, a clock later
  Bit idle = 1;    // the level as it is seen is 0
  Bit busy = 0;    // it is 1

  Out clock(const In& in) {
    const Out out{.works = busy};
    const Bit before = level;
    if (in.a_clk) level ^= in.turn;
    if (in.b_clk) {
      busy = FAULT != 0 ? before : second;
      idle = !busy;
      second = first;
      first = before;
    }
    return out;
  }

  void reset_at_once(const In& in) {
    if (!in.a_rst_n) level = 0;
    if (in.b_rst) {
      first = 0;
      second = 0;
      idle = 1;
      busy = 0;
    }
  }
};
