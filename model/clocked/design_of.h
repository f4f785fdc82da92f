// The design of a golden model that is a struct: its records, its reset, its clock.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <typeindex>
#include <utility>

#include "model/clocked/asked.h"
#include "model/clocked/says.h"
#include "model/core/design.h"
#include "model/core/input_error.h"

namespace cosim::clocked {

/// Whether a model's jobs are made of work of another type.
template <class M>
concept HasWork = requires {
  typename M::Work;
};
/// The jobs of a design whose model has struct Job.
template <class... Models>
struct JobRecords {};
template <class First, class... Models>
requires(!HasWork<First> && requires { typename First::Job; }) struct JobRecords<First, Models...> {
  template <class V>
  using Job = ModelRecord<V, RecordTable<typename First::Job, typename Models::Job...>>;
  template <class V>
  using Driver = ModelRecord<V, RecordTable<typename First::Driver, typename Models::Driver...>>;
};
template <HasWork First, class... Models>
struct JobRecords<First, Models...> {
  using Job = typename First::Work;
  template <class V>
  using Task = ModelRecord<V, RecordTable<typename First::Job, typename Models::Job...>>;
  template <class V>
  using Driver = ModelRecord<V, RecordTable<typename First::Driver, typename Models::Driver...>>;
};
template <class... Models>
struct CheckerRecords {};
template <class First, class... Models>
requires requires { typename First::Checker; }
struct CheckerRecords<First, Models...> {
  template <class V>
  using Checker = ModelRecord<V, RecordTable<typename First::Checker, typename Models::Checker...>>;
};

/// What a person wants to see of a design whose model has a View (model/core/probe.h).
template <class Design, class First>
struct ViewOfModel {};
template <class Design, class First>
requires requires { typename First::View; }
struct ViewOfModel<Design, First> {
  class View : public First::View {
   public:
    template <class P>
    static constexpr auto probes(const P&) {
      return First::View::probes();
    }
    template <class P, class S, class O>
    void clock(const P& p, const S& state, const O& out) {
      typename First::View& view = *this;  // GCC 12 captures no `this` in such a lambda
      Design::shaped(p, [&](auto of) {
        using M = typename decltype(of)::type;
        view.clock(object_of<M>(state), object_of<typename M::Out>(out));
      });
    }
  };
};

/// The design of the models, one for each shape, which are one struct with its parameters. `Says`
/// has what CMake knows of them:
///
///   name         "uart"
///   parameters   a std::array of Parameter for each shape
///   files        the path of what each shape's exporter wrote, without .btor2
template <class Says, class FirstModel, class... More>
struct DesignOf : JobRecords<FirstModel, More...>,
                  CheckerRecords<FirstModel, More...>,
                  ViewOfModel<DesignOf<Says, FirstModel, More...>, FirstModel> {
  using First = FirstModel;
  struct Params : Shape {
    using Design = DesignOf;
  };
  using In = typename First::In;
  template <class V>
  using Inputs = ModelRecord<V, RecordTable<In, typename More::In...>>;
  template <class V>
  using Outputs = ModelRecord<V, RecordTable<typename First::Out, typename More::Out...>>;
  template <class V>
  using State = ModelRecord<V, RecordTable<First, More...>>;
  template <class V>
  using Registers = ModelRecord<V, RegisterTable<First, More...>>;
  template <class V>
  using Step = StepOf<State<V>, Outputs<V>>;

  static constexpr const char* name = Says::name;
  static constexpr const char* source = [] {
    if constexpr (requires { First::source; }) {
      return First::source;
    } else {
      return "";
    }
  }();
  static constexpr auto unobserved = [] {
    if constexpr (requires { First::unobserved; }) {
      return First::unobserved;
    } else {
      std::array<const char*, 0> none{};
      return none;
    }
  }();
  static constexpr int reset_clocks = [] {
    if constexpr (requires { First::reset_clocks; }) {
      return First::reset_clocks;
    } else if constexpr (SaysReset<First>) {
      return 1;
    } else {
      return 0;
    }
  }();
  static constexpr std::uint64_t most_clocks = [] {
    if constexpr (requires { First::most_clocks; }) {
      return static_cast<std::uint64_t>(First::most_clocks);
    } else {
      return static_cast<std::uint64_t>(1'000'000);
    }
  }();
  static constexpr bool asynchronous_reset = [] {
    if constexpr (requires { First::asynchronous_reset; }) {
      return First::asynchronous_reset;
    } else {
      return false;
    }
  }();

  /// The shape with these numbers as its parameters, in their order.
  static constexpr Params shape_of(std::initializer_list<int> numbers) {
    for (Params p; p.number < int(1 + sizeof...(More)); ++p.number) {
      const auto all = parameters(p);
      if (std::equal(all.begin(), all.end(), numbers.begin(), numbers.end(),
                     [](const Parameter& one, int number) { return one.value == number; })) {
        return p;
      }
    }
    throw InputError(std::string(name) + ": no such shape was built");
  }
  static constexpr auto parameters(const Params& p) {
    return Says::parameters[std::size_t(p.number)];
  }
  static constexpr Inputs<Word> rest() { return record_of<Inputs<Word>>(resting<First>(false)); }
  static constexpr Inputs<Word> reset_inputs() requires SaysReset<First> {
    return record_of<Inputs<Word>>(resting<First>(true));
  }
  template <class V>
  static constexpr State<V> reset_state(const Params& p) {
    const auto words = shaped(p, [](auto of) {
      using M = typename decltype(of)::type;
      return record_of<State<Word>>(M{});
    });
    State<V> s;
    for_each_member<State<V>>([&](auto member, auto first) {
      constexpr std::size_t at = decltype(first)::value;
      const auto all = to_words(words);
      if constexpr (requires { (s.*member).begin(); }) {
        for (int i = 0; i < (s.*member).size; ++i) (s.*member)[i] = V(all[at + std::size_t(i)]);
      } else {
        s.*member = V(all[at]);
      }
    });
    return s;
  }

  static constexpr Step<Word> next(const Params& p, const State<Word>& s, const Inputs<Word>& in) {
    check_clock<First>();
    return shaped(p, [&](auto of) {
      using M = typename decltype(of)::type;
      auto model = object_of<M>(s);
      const auto out = model.clock(object_of<typename M::In>(in));
      Step<Word> step;
      step.state = record_of<State<Word>>(model);
      step.outputs = codes_of<Outputs<Word>>(out);
      return step;
    });
  }
  template <class V>
  static auto next(const Params& p, const State<V>& s, const Inputs<V>& in) requires requires {
    SymbolsOf<V>();
  }
  {
    const Asked<V> question = asked(p, s, in);
    return Step<V>{answer<State<V>>(p, question, "next"), answer<Outputs<V>>(p, question, "out")};
  }
  /// The ways through clock(): the words of each, and whether it is taken.
  template <class V>
  static auto ways(const Params& p, const State<V>& s, const Inputs<V>& in) {
    return SymbolsOf<V>::ways(asked(".ways", p, s, in));
  }
  /// The path that the names of its exporter's files begin with.
  static std::string file(const Params& p) {
    return std::string(Says::files[std::size_t(p.number)]);
  }
  /// What that shape's exporter wrote, to be asked for a clock in these states and with these
  /// inputs; `more`: which of its files.
  template <class S, class... I>
  static auto asked(const Params& p, const S& states, const I&... inputs) {
    return asked("", p, states, inputs...);
  }
  template <class V, class S, class... I>
  static Asked<V> asked(const char* more, const Params& p, const ModelRecord<V, S>& states,
                        const I&... inputs) {
    Asked<V> all{file(p) + more, {}, cells_of(p, states)};
    const auto add = [&](const auto& record) {
      for (const auto& cell : cells_of(p, record)) all.inputs.push_back(cell);
    };
    (add(inputs), ...);
    return all;
  }
  /// f(of), `of` a std::type_identity of that shape's model.
  template <class F>
  static constexpr auto shaped(const Params& p, const F& f) {
    return pick<0, F, First, More...>(p.number, f);
  }
  /// That model.
  static std::type_index model(const Params& p) {
    return shaped(p, [](auto of) {
      using M = typename decltype(of)::type;
      return std::type_index(typeid(M));
    });
  }
  /// What the RTL's registers hold: codes.
  template <class V>
  static constexpr Registers<V> registers(const Params& p, const State<V>& s) {
    Registers<V> codes;
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      ((codes.template leaf<I>() = s.template leaf<I>()), ...);
    }
    (std::make_index_sequence<Registers<V>::Table::leaves>());
    const auto& fields = Registers<V>::fields(p);
    cosim::for_each_cell<Registers<V>>([&](auto cell, std::size_t i) {
      const Field& f = fields[i];
      if (f.width == 0) cell(codes) = V(0);
      if (f.format == Format::twos_complement) cell(codes) = low_bits(cell(codes), f.width);
      if (f.format == Format::ones_complement) {
        const V number = cell(codes), all = V(ones(f.width));
        const V zero = State<V>::Table::has_minus_zero[i] ? all : V(0);
        cell(codes) = select(number < V(0), number + all, select(number == V(0), zero, number));
      }
    });
    return codes;
  }

 private:
  template <int N, class F, class M, class... Others>
  static constexpr auto pick(int number, const F& f) {
    if constexpr (sizeof...(Others) == 0) {
      return f(std::type_identity<M>());
    } else {
      if (number == N) return f(std::type_identity<M>());
      return pick<N + 1, F, Others...>(number, f);
    }
  }
};

}  // namespace cosim::clocked
