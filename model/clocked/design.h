// A golden model that is a struct, as the type that the harness is generic over (model/core/
// design.h). On machine integers the struct itself runs; on symbols, what its exporter wrote of it.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

#include "model/clocked/model.h"
#include "model/clocked/records.h"
#include "model/core/design.h"
#include "model/core/job.h"

namespace cosim::clocked {

/// What runs an exported model on a value type that is a symbol: SymbolsOf<V>::gives(), below.
template <class V>
struct SymbolsOf;

/// A value, and the field that it is one of.
template <class V>
struct SymbolCell {
  Field field;
  V value;
};
/// What an exported model is asked for a clock of.
template <class V>
struct Asked {
  std::string file;                           ///< without .btor2
  std::vector<SymbolCell<V>> inputs, states;  ///< in the file's order
};
/// The cells of a record that its shape has.
template <class V, class Table>
std::vector<SymbolCell<V>> cells_of(const Shape& shape, const ModelRecord<V, Table>& record) {
  std::vector<SymbolCell<V>> all;
  const auto fields = Table::fields(shape);
  cosim::for_each_cell<ModelRecord<V, Table>>([&](auto cell, std::size_t i) {
    if (fields[i].width != 0) all.push_back({fields[i], cell(record)});
  });
  return all;
}
/// A record of what it gives in a section of the file (export.h): of "next" numbers, else codes.
template <class Record, class V>
Record answer(const Shape& shape, const Asked<V>& asked, const char* section) {
  std::vector<SymbolCell<V>> wanted = cells_of(shape, Record{});
  SymbolsOf<V>::give(asked, section, wanted);
  Record r{};
  const auto fields = Record::Table::fields(shape);
  std::size_t at = 0;
  cosim::for_each_cell<Record>([&](auto cell, std::size_t i) {
    if (fields[i].width != 0) cell(r) = wanted[at++].value;
  });
  return r;
}
/// The object that a record is.
template <class T, class Record>
constexpr T object_of(const Record& record) {
  T object = zero<T>();
  take_record(record, object);
  return object;
}

/// What a function of a model gives as sentences with conditions: those, or one condition.
template <class T>
constexpr auto sentences(const char* of_one, const T& given) {
  if constexpr (Operand<T>) {
    return std::array<Stated, 1>{{{of_one, Bit(given)}}};
  } else {
    return given;
  }
}

/// The jobs of a design whose model has struct Job.
template <class... Models>
struct JobRecords {};
template <class First, class... Models>
requires requires { typename First::Job; }
struct JobRecords<First, Models...> {
  template <class V>
  using Job = ModelRecord<V, RecordTable<typename First::Job, typename Models::Job...>>;
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

// What a model may have: says.h.
template <class M>
concept SaysResetAtOnce = requires(M m, const typename M::In& in) {
  m.reset_at_once(in);
};
template <class M>
concept SaysCases = requires(const M m, const typename M::In& in) {
  m.cases(in);
};
template <class M>
concept SaysLegal = requires(const M m, const typename M::In& in) {
  m.legal(in);
};
template <class M>
concept SaysIdle = requires(const M m) {
  m.idle();
};
template <class M>
concept SaysInvariant = requires(const M m) {
  m.invariant();
};
template <class M>
concept SaysReached = requires(const M m) {
  m.reached();
};
template <class M>
concept SaysRegistersCompared = requires(const M m) {
  m.compared();
};
template <class M>
concept SaysOutputsCompared = requires(const M m, const typename M::In& in,
                                       const typename M::Out& out) {
  m.compared(in, out);
};

/// The design of the models, one for each shape, which are one struct with its parameters. `Says`
/// has what CMake knows of them:
///
///   name         "uart"
///   parameters   a std::array of Parameter for each shape
///   files        the path of what each shape's exporter wrote, without .btor2
template <class Says, class FirstModel, class... More>
struct DesignOf : JobRecords<FirstModel, More...>, CheckerRecords<FirstModel, More...> {
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
  /// What that shape's exporter wrote, to be asked for a clock in these states and with these
  /// inputs; `more`: which of its files.
  template <class S, class... I>
  static auto asked(const Params& p, const S& states, const I&... inputs) {
    return asked("", p, states, inputs...);
  }
  template <class V, class S, class... I>
  static Asked<V> asked(const char* more, const Params& p, const ModelRecord<V, S>& states,
                        const I&... inputs) {
    Asked<V> all{std::string(Says::files[p.number]) + more, {}, cells_of(p, states)};
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
    const auto fields = Registers<V>::fields(p);
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

// What a model says beside its clock, as functions that are found by p (model/core/design.h,
// job.h).

template <class P>
concept IsShape = requires {
  typename P::Design;
  requires std::derived_from<P, Shape>;
};
template <class P>
using FirstOf = typename P::Design::First;

/// Sentences of a model: call(model, in, out) gives them, and on symbols SECTION of its file says
/// whether they hold.
template <class V, class P, class Call>
constexpr auto said(const char* section, const P& p, const typename P::Design::template State<V>& s,
                    const typename P::Design::template Inputs<V>& in,
                    const typename P::Design::template Outputs<V>& out, const Call& call) {
  using Design = typename P::Design;
  const auto words = [&](const auto& state, const auto& inputs, const auto& outputs) {
    return Design::shaped(p, [&](auto of) {
      using M = typename decltype(of)::type;
      const auto list =
          sentences(section, call(object_of<M>(state), object_of<typename M::In>(inputs),
                                  object_of<typename M::Out>(outputs)));
      return [&]<std::size_t... I>(std::index_sequence<I...>) {
        return std::array{cosim::Stated<Word>(list[I].sentence, bool(list[I].holds))...};
      }
      (std::make_index_sequence<std::tuple_size_v<decltype(list)>>());
    });
  };
  if constexpr (std::same_as<V, Word>) {
    return words(s, in, out);
  } else {
    const auto list =
        words(typename Design::template State<Word>{}, typename Design::template Inputs<Word>{},
              typename Design::template Outputs<Word>{});
    const auto holds = SymbolsOf<V>::conditions(Design::asked(p, s, in), section);
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return std::array{cosim::Stated<V>(list[I].sentence, holds[I])...};
    }
    (std::make_index_sequence<std::tuple_size_v<decltype(list)>>());
  }
}
template <class P, class V, class S, class I>
requires IsShape<P> && SaysCases<FirstOf<P>>
constexpr auto cases(const P& p, const ModelRecord<V, S>& s, const ModelRecord<V, I>& in) {
  return said<V>("cases", p, s, in, {},
                 [](const auto& m, const auto& i, const auto&) { return m.cases(i); });
}
template <class P, class V, class S, class I>
requires IsShape<P> && SaysLegal<FirstOf<P>>
constexpr auto legal(const P& p, const ModelRecord<V, S>& s, const ModelRecord<V, I>& in) {
  return said<V>("legal", p, s, in, {},
                 [](const auto& m, const auto& i, const auto&) { return m.legal(i); });
}
template <class P, class V, class S>
requires IsShape<P> && SaysInvariant<FirstOf<P>>
constexpr auto invariant(const P& p, const ModelRecord<V, S>& s) {
  return said<V>("invariant", p, s, {}, {},
                 [](const auto& m, const auto&, const auto&) { return m.invariant(); });
}
template <class P, class V, class S>
requires IsShape<P> && SaysReached<FirstOf<P>>
constexpr auto reached(const P& p, const ModelRecord<V, S>& s) {
  return said<V>("reached", p, s, {}, {},
                 [](const auto& m, const auto&, const auto&) { return m.reached(); });
}
template <class P, class V, class S>
requires IsShape<P> && SaysRegistersCompared<FirstOf<P>>
constexpr auto compared(const P& p, const ModelRecord<V, S>& s) {
  return said<V>("registers", p, s, {}, {},
                 [](const auto& m, const auto&, const auto&) { return m.compared(); });
}
template <class P, class V, class S, class I, class O>
requires IsShape<P> && SaysOutputsCompared<FirstOf<P>>
constexpr auto compared(const P& p, const ModelRecord<V, S>& s, const ModelRecord<V, I>& in,
                        const ModelRecord<V, O>& out) {
  return said<V>("outputs", p, s, in, out,
                 [](const auto& m, const auto& i, const auto& o) { return m.compared(i, o); });
}
template <class P, class V, class S>
requires IsShape<P> && SaysIdle<FirstOf<P>>
constexpr auto idle(const P& p, const ModelRecord<V, S>& s) {
  using Design = typename P::Design;
  using Inputs = typename Design::template Inputs<V>;
  if constexpr (std::same_as<V, Word>) {
    return Design::shaped(p, [&](auto of) {
      using M = typename decltype(of)::type;
      return codes_of<Inputs>(object_of<M>(s).idle());
    });
  } else {
    return answer<Inputs>(p, Design::asked(p, s, Inputs{}), "idle");
  }
}
template <class P, class V, class S, class I>
requires IsShape<P> && SaysResetAtOnce<FirstOf<P>>
constexpr auto reset(const P& p, const ModelRecord<V, S>& s, const ModelRecord<V, I>& in) {
  using Design = typename P::Design;
  using State = typename Design::template State<V>;
  if constexpr (std::same_as<V, Word>) {
    return Design::shaped(p, [&](auto of) {
      using M = typename decltype(of)::type;
      M model = object_of<M>(s);
      model.reset_at_once(object_of<typename M::In>(in));
      return record_of<State>(model);
    });
  } else {
    return answer<State>(p, Design::asked(p, s, in), "reset");
  }
}

template <class P, class V, class J, class D, class I>
requires IsShape<P>
constexpr auto drive(const P& p, const ModelRecord<V, J>& job, const ModelRecord<V, D>& driver,
                     const ModelRecord<V, I>& rest) {
  using Inputs = ModelRecord<V, I>;
  if constexpr (std::same_as<V, Word>) {
    return P::Design::shaped(p, [&](auto of) {
      using M = typename decltype(of)::type;
      return codes_of<Inputs>(object_of<typename M::Driver>(driver).drive(
          object_of<typename M::Job>(job), object_of<typename M::In>(rest)));
    });
  } else {
    // The driver does not see what the outputs are.
    using Outputs = typename P::Design::template Outputs<V>;
    return answer<Inputs>(p, P::Design::asked(".driver", p, driver, job, Outputs{}), "drive");
  }
}
template <class P, class V, class J, class D, class O>
requires IsShape<P>
constexpr auto driven(const P& p, const ModelRecord<V, J>& job, const ModelRecord<V, D>& driver,
                      const ModelRecord<V, O>& out) {
  using Driver = ModelRecord<V, D>;
  using Turn = cosim::Turn<P::Design::template Driver, V>;
  if constexpr (std::same_as<V, Word>) {
    return P::Design::shaped(p, [&](auto of) {
      using M = typename decltype(of)::type;
      auto device = object_of<typename M::Driver>(driver);
      const Bit over =
          device.driven(object_of<typename M::Job>(job), object_of<typename M::Out>(out));
      return Turn{record_of<Driver>(device), bool(over)};
    });
  } else {
    const auto asked = P::Design::asked(".driver", p, driver, job, out);
    return Turn{answer<Driver>(p, asked, "next"), SymbolsOf<V>::conditions(asked, "over")[0]};
  }
}
template <class P, class V, class J, class D, class C, class O>
requires IsShape<P>
constexpr auto checked(const P& p, const ModelRecord<V, J>& job, const ModelRecord<V, D>& driver,
                       const ModelRecord<V, C>& checker, const ModelRecord<V, O>& out,
                       Condition<V> over) {
  using Checker = ModelRecord<V, C>;
  using Verdict = cosim::Verdict<P::Design::template Checker, V>;
  if constexpr (std::same_as<V, Word>) {
    return P::Design::shaped(p, [&](auto of) {
      using M = typename decltype(of)::type;
      auto check = object_of<typename M::Checker>(checker);
      const Bit wrong =
          check.checked(object_of<typename M::Job>(job), object_of<typename M::Driver>(driver),
                        object_of<typename M::Out>(out), Bit(over));
      return Verdict{record_of<Checker>(check), bool(wrong)};
    });
  } else {
    auto asked = P::Design::asked(".checker", p, checker, job, driver, out);
    asked.inputs.push_back({{"over", 1, Format::flag, "", ""}, flag<V>(over)});
    return Verdict{answer<Checker>(p, asked, "next"), SymbolsOf<V>::conditions(asked, "wrong")[0]};
  }
}

}  // namespace cosim::clocked
