// What may happen to a transaction of a stream: the results of cases() of a stream model.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

#include "model/clocked/says.h"

namespace cosim::clocked {

/// Each sentence of `first` together with each of `second`; the result of crossed().
template <std::size_t N, std::size_t M>
struct Crossed {
  std::array<Stated, N> first;
  std::array<Stated, M> second;
};
/// crossed(stated({{"a load", loads}, {"a store", stores}}), stated({{"it traps", traps}}))
template <std::size_t N, std::size_t M>
constexpr Crossed<N, M> crossed(const std::array<Stated, N>& first,
                                const std::array<Stated, M>& second) {
  return {first, second};
}

/// Calls visit(sentence, "", holds) for each of these, or, of two that are crossed,
/// visit(sentence, other sentence, holds).
template <std::size_t N, class Visit>
constexpr void for_each_case(const std::array<Stated, N>& cases, const Visit& visit) {
  for (const Stated& one : cases) visit(one.sentence, "", static_cast<bool>(one.holds));
}
template <std::size_t N, std::size_t M, class Visit>
constexpr void for_each_case(const Crossed<N, M>& cases, const Visit& visit) {
  for (const Stated& a : cases.first) {
    for (const Stated& b : cases.second) {
      visit(a.sentence, b.sentence, static_cast<bool>(a.holds) && static_cast<bool>(b.holds));
    }
  }
}
template <class... Some, class Visit>
constexpr void for_each_case(const std::tuple<Some...>& cases, const Visit& visit) {
  std::apply([&](const auto&... some) { (for_each_case(some, visit), ...); }, cases);
}

/// A model of streams says with cases(x), or with cases(x, before), what may happen to an X.
template <class M, class X>
concept SaysCasesOfOne = requires(const X& x) {
  M::cases(x);
};
template <class M, class X>
concept SaysCasesOfTwo = requires(const X& x, const X* before) {
  M::cases(x, before);
};
template <class M, class X>
concept SaysStreamCases = SaysCasesOfOne<M, X> || SaysCasesOfTwo<M, X>;

/// `before`: the transaction before it in its stream, null of the first one of a case.
template <class M, class X>
constexpr auto stream_cases(const X& x, [[maybe_unused]] const X* before) {
  if constexpr (requires { M::cases(x, before); }) {
    return M::cases(x, before);
  } else {
    return M::cases(x);
  }
}

/// A model of streams says with compared(y) which fields of an expected Y are compared.
template <class M, class Y>
concept SaysComparedFields = requires(const Y& y) {
  M::compared(y);
};

}  // namespace cosim::clocked
