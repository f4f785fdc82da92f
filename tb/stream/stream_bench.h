// The bench of one shape of a design with a stream model: what of it needs the model's types.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/clocked/says.h"
#include "model/clocked/stream.h"
#include "model/core/design.h"
#include "tb/stream/bench.h"
#include "tb/stream/codes.h"
#include "tb/stream/own_of.h"

namespace cosim {
namespace detail {

template <class T>
struct IsTuple : std::false_type {};
template <class... T>
struct IsTuple<std::tuple<T...>> : std::true_type {};

/// One thing alone as a tuple of it.
template <class T>
constexpr auto as_tuple(T one) {
  if constexpr (IsTuple<T>::value) {
    return one;
  } else {
    return std::tuple<T>(std::move(one));
  }
}

/// Calls visit(i) for each i < N, a constant by its type; gives its results as a tuple.
template <std::size_t N, class Visit>
constexpr auto each(const Visit& visit) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::tuple{visit(std::integral_constant<std::size_t, I>())...};
  }
  (std::make_index_sequence<N>());
}

}  // namespace detail

/// Trait has Model, Design, params, and the names of the clock. Instance is the RTL.
template <class Trait, class Instance>
class StreamBench final : public AnyStreamBench {
  using M = typename Trait::Model;
  static_assert(
      requires {
        M::in();
        M::out();
      },
      "a model of streams has in(), out() and run()");
  using In = decltype(detail::as_tuple(M::in()));
  using Out = decltype(detail::as_tuple(M::out()));
  template <std::size_t S, class Side>
  using StreamOf = std::tuple_element_t<S, Side>;
  template <std::size_t S, class Side>
  using CodesOf = detail::Codes<typename StreamOf<S, Side>::Record>;

 public:
  /// `open`: the same with its whole hierarchy open, where there is one.
  explicit StreamBench(std::optional<OpenClass> open = {}) : open_(open) {
    using Design = typename Trait::Design;
    if constexpr (StepsOn<Design, Word>) tables_.view = "streams";
    tables_.design = Design::name;
    shape_.set_clocks(Trait::clock, Trait::clocks);
    const auto parameters = parameters_of<Design>(Trait::params);
    tables_.parameters.assign(parameters.begin(), parameters.end());
    shape_.title = title();
    if constexpr (requires { M::watchdog; }) shape_.watchdog = M::watchdog;
    if constexpr (requires { M::pins(); }) {
      const auto pins = M::pins();
      shape_.pins.assign(pins.begin(), pins.end());
    }
    add_all<true>(detail::as_tuple(M::in()));
    add_all<false>(detail::as_tuple(M::out()));
    fill_tables();
  }

  std::unique_ptr<StreamDut> dut(std::uint32_t power_up) const override {
    return std::make_unique<Instance>(power_up);
  }
  std::unique_ptr<StreamDut> open_dut(std::uint32_t power_up) const override {
    if (!open_) return dut(power_up);
    return std::make_unique<OpenStreamDut>(*open_, power_up);
  }

  void expect(const std::vector<Sequence>& given, std::vector<Sequence>& all) const override {
    const auto results = run(each_in([&](auto s) { return CodesOf<s, In>::objects(given[s]); }));
    each_out([&](auto s) {
      if (all.size() == s) all.emplace_back(shape_.out[s].cells.size());
      all[s].clear();
      std::vector<Word> words(all[s].cells());
      for (const auto& one : std::get<s>(results)) {
        CodesOf<s, Out>::put(one, words);
        all[s].push(words);
      }
      return 0;
    });
  }

  StreamSizes sizes(const std::vector<Sequence>& given) const override {
    // Each transaction is made once, and once in the vector that the model is given.
    return [&given, some = each_in([](auto s) {
                      return std::vector<typename StreamOf<s, In>::Record>();
                    })](std::span<const std::size_t> taken, std::span<std::size_t> sizes) mutable {
      each_in([&](auto s) {
        auto& all = std::get<s>(some);
        if (all.size() > taken[s]) all.clear();
        all.reserve(given[s].size());
        while (all.size() < taken[s]) all.push_back(CodesOf<s, In>::object(given[s][all.size()]));
        return 0;
      });
      const auto results = run(some);
      each_out([&](auto s) { return sizes[s] = std::get<s>(results).size(); });
    };
  }

  const char* broken_rule(std::size_t stream, std::span<const Word> words) const override {
    const char* broken = nullptr;
    each_in([&](auto s) {
      if (s != stream) return 0;
      for (const auto& rule : rules_of(CodesOf<s, In>::object(words))) {
        if (broken == nullptr && !rule.holds) broken = rule.sentence;
      }
      return 0;
    });
    return broken;
  }

 private:
  template <class Visit>
  static auto each_in(const Visit& visit) {
    return detail::each<std::tuple_size_v<In>>(visit);
  }
  template <class Visit>
  static auto each_out(const Visit& visit) {
    return detail::each<std::tuple_size_v<Out>>(visit);
  }
  template <class Given>
  static auto run(const Given& given) {
    return detail::as_tuple(
        std::apply([](const auto&... stream) { return M::run(stream...); }, given));
  }
  /// What is assumed of a transaction, and whether it holds.
  template <class X>
  static auto rules_of(const X& x) {
    if constexpr (requires { M::legal(x); }) {
      return M::legal(x);
    } else {
      return std::array<clocked::Stated, 0>();
    }
  }
  template <bool goes_in, class Side>
  void add_all(const Side& side) {
    detail::each<std::tuple_size_v<Side>>([&](auto s) {
      using X = typename StreamOf<s, Side>::Record;
      const auto& ports = std::get<s>(side).ports;
      shape_.add(ports, goes_in, detail::Codes<X>::fields(),
                 detail::own_driver<typename StreamOf<s, Side>::Own, X, goes_in>());
      if (!goes_in) return 0;
      for (const auto& rule : rules_of(clocked::zero<X>())) {
        tables_.assumed.push_back(std::string(ports.name) + ": " + rule.sentence);
      }
      return 0;
    });
  }

  std::optional<OpenClass> open_;
};

}  // namespace cosim
