// How a field of a transaction is drawn: what draws() of a model of streams gives.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <type_traits>
#include <vector>

namespace cosim::clocked {

/// A value, or those from `low` to `high` inclusive, drawn with the probability `weight` divided by
/// the sum of all weights of the field; weights are 0 or more, their sum at most 10^9.
struct Share {
  std::int64_t low = 0, high = 0;
  std::uint64_t weight = 1;
  bool is_any = false;  ///< every value of the field; low and high are not used

  template <class V>
  requires(std::integral<V> || std::is_enum_v<V>) constexpr Share(V value, int its_weight = 1)
      : Share(value, value, its_weight) {}
  template <class V>
  requires(std::integral<V> || std::is_enum_v<V>) constexpr Share(V from, V to, int its_weight)
      : low(static_cast<std::int64_t>(from)),
        high(static_cast<std::int64_t>(to)),
        weight(static_cast<std::uint64_t>(its_weight)) {}
};
/// As for a field without a rule: a random value, or now and then 0, all ones or a single bit.
constexpr Share any(int weight = 1) {
  Share share(0, weight);
  share.is_any = true;
  return share;
}

/// The rule by which a member of a transaction X is drawn.
template <class X, class T>
struct Drawn {
  using Record = X;
  T X::*field;
  std::vector<Share> shares;
};
/// drawn(&X::address, {0, 4, {8, 63, 3}, any(1)}): 0 and 4 are drawn with weight 1, the values from
/// 8 to 63 with weight 3 together, and anything with weight 1.
template <class X, class T>
Drawn<X, T> drawn(T X::*field, std::initializer_list<Share> shares) {
  return {field, shares};
}

}  // namespace cosim::clocked
