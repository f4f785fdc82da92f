// The bench of one shape of a design with a stream model: what of it needs the design's types.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/core/design.h"
#include "model/core/input_error.h"
#include "model/core/stream.h"
#include "tb/stream/bench.h"
#include "tb/stream/own_of.h"
#include "tb/stream/payload.h"

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

}  // namespace detail

/// Trait has Design, params, and the names of the shape and of the clock. Instance is the RTL.
template <class Trait, class Instance>
class StreamBench final : public AnyStreamBench {
  using Design = typename Trait::Design;
  using In = decltype(detail::as_tuple(Design::in(Trait::params)));
  using Out = decltype(detail::as_tuple(Design::out(Trait::params)));
  template <std::size_t S, class Side>
  using RecordOf = typename std::tuple_element_t<S, Side>::template Payload<Word>;
  template <class Side>
  using Numbers = std::make_index_sequence<std::tuple_size_v<Side>>;

 public:
  /// `open`: the same with its whole hierarchy open, where there is one.
  explicit StreamBench(std::optional<OpenClass> open = {}) : open_(open) {
    if constexpr (StepsOn<Design, Word> || requires { Trait::is_beside_clocks; }) {
      tables_.view = "streams";
    }
    tables_.design = Design::name;
    if constexpr (requires { Trait::clocks; }) {
      shape_.set_clocks(Trait::clock, Trait::clocks);
    } else {
      shape_.set_clocks(Trait::clock, "");
    }
    const auto parameters = parameters_of<Design>(Trait::params);
    tables_.parameters.assign(parameters.begin(), parameters.end());
    shape_.title = title();
    if constexpr (requires { Design::watchdog; }) shape_.watchdog = Design::watchdog;
    if constexpr (requires { Design::pins(Trait::params); }) {
      const auto pins = Design::pins(Trait::params);
      shape_.pins.assign(pins.begin(), pins.end());
    }
    const auto add = [&]<class Side, std::size_t... S>(const Side& side, bool goes_in,
                                                       std::index_sequence<S...>) {
      (shape_.add(
           std::get<S>(side).ports, goes_in, RecordOf<S, Side>::fields(Trait::params),
           detail::own_driver<typename std::tuple_element_t<S, Side>::Own, RecordOf<S, Side>>(
               Trait::params, goes_in)),
       ...);
    };
    const In in = detail::as_tuple(Design::in(Trait::params));
    const Out out = detail::as_tuple(Design::out(Trait::params));
    add(in, true, Numbers<In>());
    add(out, false, Numbers<Out>());
    [&]<std::size_t... S>(std::index_sequence<S...>) { (add_rules<S>(), ...); }
    (Numbers<In>());
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
    const auto results = [&]<std::size_t... S>(std::index_sequence<S...>) {
      return detail::as_tuple(Design::run(Trait::params, payload<S, In>().records(given[S])...));
    }
    (Numbers<In>());
    while (all.size() < shape_.out.size()) {
      all.emplace_back(shape_.out[all.size()].cells.size());
    }
    [&]<std::size_t... S>(std::index_sequence<S...>) {
      (payload<S, Out>().sequence(std::get<S>(results), shape_.title, shape_.out[S].name, all[S]),
       ...);
    }
    (Numbers<Out>());
  }

  StreamSizes sizes(const std::vector<Sequence>& given) const override {
    return sizes(given, Numbers<In>(), Numbers<Out>());
  }

  const char* broken_rule(std::size_t s, std::span<const Word> words) const override {
    const char* broken = nullptr;
    [&]<std::size_t... S>(std::index_sequence<S...>) {
      ((S == s ? void(broken = broken_in<S>(words)) : void()), ...);
    }
    (Numbers<In>());
    return broken;
  }

 private:
  // Each record is made once, and once in the vector that the model is given.
  template <std::size_t... S, std::size_t... R>
  static StreamSizes sizes(const std::vector<Sequence>& given, std::index_sequence<S...>,
                           std::index_sequence<R...>) {
    return [&given, some = std::tuple<std::vector<RecordOf<S, In>>...>()](
               std::span<const std::size_t> taken, std::span<std::size_t> sizes) mutable {
      const auto take = [&](auto& records, std::size_t s, const auto& codes) {
        if (records.size() > taken[s]) records.resize(taken[s]);
        records.reserve(given[s].size());
        while (records.size() < taken[s]) records.push_back(codes.record(given[s][records.size()]));
      };
      (take(std::get<S>(some), S, payload<S, In>()), ...);
      const auto results = detail::as_tuple(Design::run(Trait::params, std::get<S>(some)...));
      ((sizes[R] = std::get<R>(results).size()), ...);
    };
  }
  template <std::size_t S, class Side>
  static const detail::Payload<RecordOf<S, Side>>& payload() {
    static const detail::Payload<RecordOf<S, Side>> one(Trait::params);
    return one;
  }
  template <std::size_t S>
  static constexpr bool has_rules = requires(const RecordOf<S, In>& r) {
    Design::legal(Trait::params, r);
  };
  template <std::size_t S>
  void add_rules() {
    if constexpr (has_rules<S>) {
      for (const auto& rule : Design::legal(Trait::params, RecordOf<S, In>{})) {
        tables_.assumed.push_back(shape_.in[S].name + ": " + rule.sentence);
      }
    }
  }
  template <std::size_t S>
  const char* broken_in([[maybe_unused]] std::span<const Word> words) const {
    if constexpr (has_rules<S>) {
      const auto record = payload<S, In>().record(words);
      for (const auto& rule : Design::legal(Trait::params, record)) {
        if (!rule.holds) return rule.sentence;
      }
    }
    return nullptr;
  }

  std::optional<OpenClass> open_;
};

}  // namespace cosim
