// A design as one type, for code that is generic over designs: struct Design of model/*/machine.h.
#pragma once

/// What struct Design takes over from its own namespace: the types of the same names, next() and
/// registers().
#define COSIM_DESIGN(space)                                                                \
  using Host = space::Host;                                                                \
  using Params = space::Params;                                                            \
  template <class V>                                                                       \
  using Inputs = space::Inputs<V>;                                                         \
  template <class V>                                                                       \
  using Outputs = space::Outputs<V>;                                                       \
  template <class V>                                                                       \
  using State = space::State<V>;                                                           \
  template <class V>                                                                       \
  using Registers = space::Registers<V>;                                                   \
  template <class V>                                                                       \
  static constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) { \
    return space::next(p, s, in);                                                          \
  }                                                                                        \
  template <class V>                                                                       \
  static constexpr Registers<V> registers(const Params& p, const State<V>& s) {            \
    return space::registers(p, s);                                                         \
  }                                                                                        \
  static_assert(true, "so that a semicolon stands behind it")
