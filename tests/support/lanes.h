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
  friend Mask operator!(const Mask& a) {
    return {each_lane([&](std::size_t i) { return !a.lane[i]; })};
  }
  friend Mask operator&(const Mask& a, const Mask& b) {
    return {each_lane([&](std::size_t i) { return a.lane[i] && b.lane[i]; })};
  }
  friend Mask operator|(const Mask& a, const Mask& b) {
    return {each_lane([&](std::size_t i) { return a.lane[i] || b.lane[i]; })};
  }
  friend Mask operator^(const Mask& a, const Mask& b) {
    return {each_lane([&](std::size_t i) { return a.lane[i] != b.lane[i]; })};
  }
};

struct Lanes {
  std::array<Word, kLanes> lane{};
  Lanes() = default;
  explicit Lanes(Word all) { lane.fill(all); }
  explicit Lanes(const std::array<Word, kLanes>& each) : lane(each) {}

  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return Lanes(each_lane([&](std::size_t i) { return a.lane[i] + b.lane[i]; }));
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return Lanes(each_lane([&](std::size_t i) { return a.lane[i] - b.lane[i]; }));
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return Lanes(each_lane([&](std::size_t i) { return a.lane[i] * b.lane[i]; }));
  }
  friend Lanes operator&(const Lanes& a, const Lanes& b) {
    return Lanes(each_lane([&](std::size_t i) { return a.lane[i] & b.lane[i]; }));
  }
  friend Lanes operator|(const Lanes& a, const Lanes& b) {
    return Lanes(each_lane([&](std::size_t i) { return a.lane[i] | b.lane[i]; }));
  }
  friend Lanes operator^(const Lanes& a, const Lanes& b) {
    return Lanes(each_lane([&](std::size_t i) { return a.lane[i] ^ b.lane[i]; }));
  }
  friend Mask operator<(const Lanes& a, const Lanes& b) {
    return {each_lane([&](std::size_t i) { return a.lane[i] < b.lane[i]; })};
  }
  friend Mask operator>(const Lanes& a, const Lanes& b) {
    return {each_lane([&](std::size_t i) { return a.lane[i] > b.lane[i]; })};
  }
  friend Mask operator==(const Lanes& a, const Lanes& b) {
    return {each_lane([&](std::size_t i) { return a.lane[i] == b.lane[i]; })};
  }
};

inline Lanes low_bits(const Lanes& v, int width) {
  return Lanes(each_lane([&](std::size_t i) { return cosim::low_bits(v.lane[i], width); }));
}
inline Mask bit(const Lanes& v, int b) {
  return {each_lane([&](std::size_t i) { return cosim::bit(v.lane[i], b); })};
}
inline Lanes shift_left(const Lanes& v, int n) {
  return Lanes(each_lane([&](std::size_t i) { return cosim::shift_left(v.lane[i], n); }));
}
inline Lanes shift_right(const Lanes& v, int n) {
  return Lanes(each_lane([&](std::size_t i) { return cosim::shift_right(v.lane[i], n); }));
}
inline Lanes shift_left(const Lanes& a, const Lanes& b) {
  return Lanes(each_lane([&](std::size_t i) { return cosim::shift_left(a.lane[i], b.lane[i]); }));
}
inline Lanes shift_right(const Lanes& a, const Lanes& b) {
  return Lanes(each_lane([&](std::size_t i) { return cosim::shift_right(a.lane[i], b.lane[i]); }));
}
inline Lanes add(const Lanes& a, const Lanes& b) {
  return Lanes(each_lane([&](std::size_t i) { return cosim::add(a.lane[i], b.lane[i]); }));
}
inline Lanes subtract(const Lanes& a, const Lanes& b) {
  return Lanes(each_lane([&](std::size_t i) { return cosim::subtract(a.lane[i], b.lane[i]); }));
}
inline Lanes multiply(const Lanes& a, const Lanes& b) {
  return Lanes(each_lane([&](std::size_t i) { return cosim::multiply(a.lane[i], b.lane[i]); }));
}
inline Lanes select(const Mask& c, const Lanes& a, const Lanes& b) {
  return Lanes(each_lane([&](std::size_t i) { return c.lane[i] ? a.lane[i] : b.lane[i]; }));
}

}  // namespace cosim::test
