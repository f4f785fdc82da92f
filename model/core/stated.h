// Sentences on a machine, each with its condition: what the proof assumes of a state, and what may
// happen on a clock.
#pragma once

#include "model/core/value.h"

namespace cosim {

template <class V>
struct Stated {
  const char* sentence;
  Condition<V> holds;

  /// Of machine integers conditions joined by & and | are an int.
  template <class C>
  constexpr Stated(const char* text, const C& condition)
      : sentence(text), holds(static_cast<Condition<V>>(condition)) {}
};

}  // namespace cosim
