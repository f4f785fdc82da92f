// What is true of the linear machine's state at all times, and what must happen on a clock of it.
#pragma once

#include <array>

#include "model/core/stated.h"
#include "model/linear/machine.h"

namespace cosim::linear {

/// What a state must be for RTL and model to stay equal; true after a reset and kept by every
/// clock. In any state that breaks one of these registers() does not stand for the RTL's.
template <class V>
constexpr std::array<Stated<V>, 3> invariant(const Params&, const State<V>& s) {
  return {{{"a word is formed only while a line runs", is_set(s.running) | !is_set(s.formed)},
           {"a line runs only with a code written", is_set(s.coded) | !is_set(s.running)},
           {"a word that is formed has a position left", (s.left > V(0)) | !is_set(s.formed)}}};
}

/// True of every state after a reset, and no matter to RTL and model: what a mutant may rest on.
template <class V>
constexpr std::array<Stated<V>, 2> reached(const Params&, const State<V>& s) {
  return {{{"between lines no words are counted", is_set(s.running) | (s.tick == V(0))},
           {"between lines the multiplier has no bit", is_set(s.running) | (s.last_bit == V(0))}}};
}

/// Each must be possible, and must happen under the stimuli.
template <class V>
constexpr auto cases(const Params& p, const State<V>& s, const Inputs<V>& in) {
  using Flag = Condition<V>;
  const Flag reset = is_set(in.reset);
  const Flag set = !reset & !is_set(in.initial_set_n);
  const Flag quiet = is_set(in.initial_set_n) & !reset;
  const Flag running = is_set(s.running);
  const Flag idle = quiet & !running;
  const Flag forming = running & !is_set(s.formed);
  const Flag word = is_set(s.formed);
  const Flag last = word & !(s.left > V(p.word()));
  const Flag between = word & (s.left > V(p.word()));
  const Flag none_left = s.left == V(0);
  const Flag bp = is_set(in.write_bp);
  const Flag uk = is_set(in.write_uk);
  const Flag start = is_set(in.start);
  const Flag coded = is_set(s.coded);
  const Flag begins = idle & start & coded & !bp & !uk;
  const Flag whole = low_bits(s.left, p.gamma()) == V(0);
  const Flag code0 = (s.low_code == V(0)) & (s.pattern == V(0));
  const Flag code1 = (s.low_code == V(ones(p.n))) & (s.pattern == V(ones(p.word() - 1)));
  return std::array<Stated<V>, 32>{
      {{"reset with no code", reset & !running & !coded},
       {"reset with a code", reset & !running & coded},
       {"reset before the first word", reset & forming},
       {"reset between words", reset & between},
       {"reset on the last word", reset & last},
       {"initial set while idle", set & !running},
       {"initial set before the first word", set & forming},
       {"initial set between words", set & between},
       {"initial set on the last word", set & last},
       {"BP written", idle & bp & !uk},
       {"UK written", idle & uk & !bp},
       {"UK written twice", idle & uk & !bp & coded},
       {"UK written with no new BP", idle & uk & !bp & !coded & none_left},
       {"BP and UK written at once", idle & bp & uk},
       {"start on the clock of a write", idle & start & uk & coded},
       {"start with no code", idle & start & !coded & !bp & !uk},
       {"start", begins},
       {"start of BP = 0", begins & none_left},
       {"start of BP = 1", begins & (s.left == V(1))},
       {"start of BP = 2^m - 1", begins & (s.left == V(ones(p.m)))},
       {"start of BP a multiple of 2^gamma", begins & whole & !none_left},
       {"start of BP no multiple of 2^gamma", begins & !whole},
       {"start with counter 4 at 2^n", begins & (registers(p, s).counter4 == V(ones(p.n) + 1))},
       {"start of UK all zeros", begins & code0},
       {"start of UK all ones", begins & code1},
       {"BP written while running", quiet & running & bp},
       {"UK written while running", quiet & running & uk},
       {"start while running", quiet & running & start},
       {"the first word", quiet & forming & !none_left},
       {"a line of no words", quiet & forming & none_left},
       {"a word that is not the last", quiet & between},
       {"the last word", quiet & last}}};
}

}  // namespace cosim::linear
