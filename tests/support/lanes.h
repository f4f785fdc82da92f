// A vector of eight machine integers as one value: eight cases at a time.
#pragma once

#include <array>
#include <cstddef>

#include "model/core/value.h"

namespace cosim::test {

constexpr std::size_t kLanes = 8;

/// f(i) for every lane i.
template <class F>
constexpr auto each_lane(F f) {
  std::array<decltype(f(std::size_t{0})), kLanes> result{};
  for (std::size_t i = 0; i < kLanes; ++i) result[i] = f(i);
  return result;
}

struct Mask {
  std::array<bool, kLanes> lane{};
};

struct Lanes {
  std::array<Word, kLanes> lane{};
  Lanes() = default;
  explicit Lanes(Word all) { lane.fill(all); }
  explicit Lanes(const std::array<Word, kLanes>& each) : lane(each) {}
};

// A function that gives of_lane for every lane i.
#define EACH_LANE(Result, function, of_lane)                          \
  inline Result function {                                            \
    return Result{each_lane([&](std::size_t i) { return of_lane; })}; \
  }                                                                   \
  static_assert(true, "so that a semicolon stands behind it")
#define OPERATOR(Result, Value, sign) \
  EACH_LANE(Result, operator sign(const Value& a, const Value& b), a.lane[i] sign b.lane[i])
#define OF_TWO(function) \
  EACH_LANE(Lanes, function(const Lanes& a, const Lanes& b), cosim::function(a.lane[i], b.lane[i]))

EACH_LANE(Mask, operator!(const Mask& a), !a.lane[i]);
EACH_LANE(Mask, operator&(const Mask& a, const Mask& b), a.lane[i] && b.lane[i]);
EACH_LANE(Mask, operator|(const Mask& a, const Mask& b), a.lane[i] || b.lane[i]);
EACH_LANE(Mask, operator^(const Mask& a, const Mask& b), a.lane[i] != b.lane[i]);
OPERATOR(Lanes, Lanes, +);
OPERATOR(Lanes, Lanes, -);
OPERATOR(Lanes, Lanes, *);
OPERATOR(Lanes, Lanes, &);
OPERATOR(Lanes, Lanes, |);
OPERATOR(Lanes, Lanes, ^);
OPERATOR(Mask, Lanes, <);
OPERATOR(Mask, Lanes, >);
OPERATOR(Mask, Lanes, ==);
OF_TWO(shift_left);
OF_TWO(shift_right);
OF_TWO(add);
OF_TWO(subtract);
OF_TWO(multiply);
EACH_LANE(Lanes, low_bits(const Lanes& v, int width), cosim::low_bits(v.lane[i], width));
EACH_LANE(Mask, bit(const Lanes& v, int b), cosim::bit(v.lane[i], b));
EACH_LANE(Lanes, shift_left(const Lanes& v, int n), cosim::shift_left(v.lane[i], n));
EACH_LANE(Lanes, shift_right(const Lanes& v, int n), cosim::shift_right(v.lane[i], n));
EACH_LANE(Lanes, select(const Mask& c, const Lanes& a, const Lanes& b),
          c.lane[i] ? a.lane[i] : b.lane[i]);

#undef OF_TWO
#undef OPERATOR
#undef EACH_LANE

}  // namespace cosim::test
