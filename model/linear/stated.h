// What is true of the linear machine's state at all times, and what may happen on a clock of it.
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

/// The clocks as a proof takes them one by one, each without those before it: here at once.
template <class V>
constexpr std::array<Stated<V>, 0> parts(const Params&, const State<V>&) {
  return {};
}

/// Each must be possible.
template <class V>
constexpr auto cases(const Params& p, const State<V>& s, const Inputs<V>& in) {
  using Flag = Condition<V>;
  const Flag reset = is_set(in.reset);
  const Flag quiet = is_set(in.initial_set_n) & !reset;
  const Flag running = is_set(s.running);
  const Flag idle = quiet & !running;
  const Flag draws = quiet & is_set(s.formed);
  const Flag last = draws & !(s.left > V(p.word()));
  const Flag bp = is_set(in.write_bp);
  const Flag uk = is_set(in.write_uk);
  const Flag start = is_set(in.start);
  return std::array<Stated<V>, 15>{
      {{"reset", reset},
       {"reset on the last word", reset & is_set(s.formed) & !(s.left > V(p.word()))},
       {"initial set", running & !reset & !is_set(in.initial_set_n)},
       {"BP written", idle & bp & !uk},
       {"UK written", idle & uk & !bp},
       {"BP and UK written at once", idle & bp & uk},
       {"start", idle & start & is_set(s.coded) & !bp & !uk},
       {"start with no code", idle & start & !is_set(s.coded) & !bp & !uk},
       {"BP written while running", quiet & running & bp},
       {"UK written while running", quiet & running & uk},
       {"start while running", quiet & running & start},
       {"the first word", quiet & running & !is_set(s.formed) & (s.left > V(0))},
       {"a line of no words", quiet & running & !is_set(s.formed) & (s.left == V(0))},
       {"a word that is not the last", draws & (s.left > V(p.word()))},
       {"the last word", last}}};
}

}  // namespace cosim::linear
