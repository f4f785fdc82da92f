// The bench of one shape of a design with a stream model: what of it needs the model's types.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/clocked/says.h"
#include "model/clocked/stream.h"
#include "model/core/design.h"
#include "model/core/input_error.h"
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

/// A model that says what an X is in words.
template <class M, class X>
concept HasText = requires(const X& x) {
  M::text_of(x);
};
/// A model whose transactions may be those of a file.
template <class M>
concept ReadsPrograms = requires(const std::string& path) {
  M::program(path);
};

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
  // Names the type of a transaction.
  template <std::size_t S, class Side>
  static constexpr const typename StreamOf<S, Side>::Record* pointer = nullptr;
  template <std::size_t S, class Side>
  using CodesOf = detail::Codes<typename StreamOf<S, Side>::Record>;

 public:
  /// `open`: the same with its whole hierarchy open, where there is one.
  explicit StreamBench(std::optional<OpenClass> open = {}) : open_(open) {
    using Design = typename Trait::Design;
    if constexpr (StepsOn<Design, Word>) tables_.view = "streams";
    tables_.design = Design::name;
    shape_.set_clocks(Trait::clock, Trait::clocks);
    const auto parameters = Design::parameters(Trait::params);
    tables_.parameters.assign(parameters.begin(), parameters.end());
    shape_.title = title();
    if constexpr (requires { M::watchdog; }) shape_.watchdog = M::watchdog;
    if constexpr (requires { M::most_transactions; }) {
      static_assert(M::most_transactions >= 1, "a case has a transaction at least");
      shape_.most_transactions = M::most_transactions;
    }
    if constexpr (requires { M::pins(); }) {
      const auto pins = M::pins();
      shape_.pins.assign(pins.begin(), pins.end());
    }
    tables_.has_programs = detail::ReadsPrograms<M>;
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

  std::string read_program(const std::string& path, std::vector<Sequence>& given) const override {
    if constexpr (detail::ReadsPrograms<M>) {
      auto [transactions, wrong] = M::program(path);
      const auto all = detail::as_tuple(std::move(transactions));
      each_in([&](auto s) {
        given.emplace_back(shape_.in[s].cells.size());
        std::vector<Word> words(given[s].cells());
        for (const auto& one : std::get<s>(all)) {
          CodesOf<s, In>::put(one, words);
          given[s].push(words);
        }
        return 0;
      });
      return wrong;
    }
    return {};
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

  std::string state_after(const std::vector<Sequence>& given) const override {
    const auto all = each_in([&](auto s) { return CodesOf<s, In>::objects(given[s]); });
    return std::apply(
        [](const auto&... stream) -> std::string {
          if constexpr (requires { M::state_after(stream...); }) {
            return M::state_after(stream...);
          } else {
            return {};
          }
        },
        all);
  }

  void count_cases(bool goes_in, std::size_t stream, const Sequence& some, std::size_t n,
                   std::span<std::uint64_t> hits) const override {
    const auto count = [&]<bool in, class X>(std::bool_constant<in>, const X*) {
      std::array<X, 2> last{clocked::zero<X>(), clocked::zero<X>()};
      for (std::size_t i = 0; i < n; ++i) {
        last[i % 2] = detail::Codes<X>::object(some[i]);
        std::size_t at = 0;
        for_each_case<in, X>(
            last[i % 2], i == 0 ? nullptr : &last[(i + 1) % 2],
            [&](const auto&, const auto&, bool holds) { hits[at++] += holds ? 1 : 0; });
      }
      return 0;
    };
    if (goes_in) {
      each_in([&](auto s) { return s == stream ? count(std::true_type(), pointer<s, In>) : 0; });
    } else {
      each_out([&](auto s) { return s == stream ? count(std::false_type(), pointer<s, Out>) : 0; });
    }
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
      Interface& i = (goes_in ? shape_.in : shape_.out).back();
      for_each_case<goes_in, X>(clocked::zero<X>(), nullptr,
                                [&](const std::string& a, const std::string& b, bool) {
                                  i.cases.push_back(b.empty() ? a : a + ", " + b);
                                });
      if constexpr (!goes_in && clocked::SaysComparedFields<M, X>) add_compared<X>(i);
      add_text<X>(i);
      if (!goes_in) return 0;
      add_draws<X>(shape_.in.back());
      for (const auto& rule : rules_of(clocked::zero<X>())) {
        tables_.assumed.push_back(std::string(ports.name) + ": " + rule.sentence);
      }
      return 0;
    });
  }

  /// Calls visit(sentence, other sentence or "", holds) for each of cases(), and for each field of
  /// an output that is compared only now and then.
  template <bool goes_in, class X, class Visit>
  static void for_each_case([[maybe_unused]] const X& x, [[maybe_unused]] const X* before,
                            const Visit& visit) {
    if constexpr (clocked::SaysStreamCases<M, X>) {
      clocked::for_each_case(clocked::stream_cases<M, X>(x, before), visit);
    }
    if constexpr (!goes_in && clocked::SaysComparedFields<M, X>) {
      for (const clocked::Stated& one : M::compared(x)) {
        visit(std::string(one.sentence) + " is compared", "", static_cast<bool>(one.holds));
      }
    }
  }
  template <class X>
  void add_compared(Interface& i) {
    const auto& fields = detail::Codes<X>::fields();
    const auto covers = [](const std::string& name, const std::string& field) {
      return field == name || field.starts_with(name + '.') || field.starts_with(name + '[');
    };
    std::vector<std::vector<bool>> covered;  // of each sentence, its cells
    for (const clocked::Stated& one : M::compared(clocked::zero<X>())) {
      std::vector<bool>& cells = covered.emplace_back();
      for (const Field& f : fields) cells.push_back(covers(one.sentence, f.name));
      if (std::ranges::count(cells, true) > 0) continue;
      throw InputError(title() + ": compared(): stream " + i.name + " has no field " +
                       one.sentence);
    }
    i.compares = [covered](std::span<const Word> expected, std::size_t cell) {
      std::size_t at = 0;
      for (const clocked::Stated& one : M::compared(detail::Codes<X>::object(expected))) {
        if (covered[at++][cell] && !static_cast<bool>(one.holds)) return false;
      }
      return true;
    };
  }
  template <class X>
  static void add_text([[maybe_unused]] Interface& i) {
    if constexpr (detail::HasText<M, X>) {
      i.text = [](std::span<const Word> words) {
        return M::text_of(detail::Codes<X>::object(words));
      };
    }
  }
  template <class X>
  void add_draws(Interface& i) {
    if constexpr (requires(const X& x) { M::arranged(x); }) {
      i.arrange = [](std::span<Word> words) {
        detail::Codes<X>::put(M::arranged(detail::Codes<X>::object(words)), words);
      };
    }
    if constexpr (requires { M::draws(); }) {
      const auto rules = detail::as_tuple(M::draws());
      detail::each<std::tuple_size_v<std::remove_const_t<decltype(rules)>>>([&](auto r) {
        const auto& rule = std::get<r>(rules);
        if constexpr (std::same_as<typename std::remove_cvref_t<decltype(rule)>::Record, X>) {
          add_draw(i, rule);
        }
        return 0;
      });
    }
  }
  template <class X, class T>
  void add_draw(Interface& i, const clocked::Drawn<X, T>& rule) {
    using Table = typename detail::Codes<X>::Table;
    X object = clocked::zero<X>();
    const auto* const begin = reinterpret_cast<const std::byte*>(&(object.*rule.field));
    clocked::for_each_leaf(object, [&](const auto& leaf, auto number) {
      const auto at = reinterpret_cast<const std::byte*>(&leaf) - begin;
      if (at < 0 || at >= static_cast<std::ptrdiff_t>(sizeof(T))) return;
      for (std::size_t c = Table::first[number]; c < Table::first[number + 1]; ++c) {
        shape_.draw(i, c, rule.shares);
      }
    });
  }

  std::optional<OpenClass> open_;
};

}  // namespace cosim
