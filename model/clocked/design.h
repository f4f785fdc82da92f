// A golden model that is a struct, as the type that the harness is generic over (model/core/
// design.h). On machine integers the struct itself runs; on symbols, what its exporter wrote of it.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "model/clocked/design_of.h"
#include "model/clocked/model.h"
#include "model/core/job.h"

namespace cosim::clocked {

/// What a function of a model gives as sentences with conditions: those, or one condition.
template <class T>
constexpr auto sentences(const char* of_one, const T& given) {
  if constexpr (Operand<T>) {
    return std::array<Stated, 1>{{{of_one, Bit(given)}}};
  } else {
    return given;
  }
}

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

/// Driver and checker as a job begins.
template <class P>
requires IsShape<P> && requires { typename FirstOf<P>::Driver; }
constexpr auto driver_of(const P& p) {
  using Driver = typename P::Design::template Driver<Word>;
  return P::Design::shaped(p, [](auto of) {
    using M = typename decltype(of)::type;
    return record_of<Driver>(typename M::Driver{});
  });
}
template <class P, class J>
requires(IsShape<P> && !HasWork<FirstOf<P>> && requires {
  typename FirstOf<P>::Checker;
}) constexpr auto checker_of(const P& p, const ModelRecord<Word, J>& /*job*/) {
  using Checker = typename P::Design::template Checker<Word>;
  return P::Design::shaped(p, [](auto of) {
    using M = typename decltype(of)::type;
    return record_of<Checker>(typename M::Checker{});
  });
}
/// The same of work, and its job.
template <class P>
requires IsShape<P> && HasWork<FirstOf<P>>
constexpr auto checker_of(const P& p, const typename FirstOf<P>::Work& work) {
  using Checker = typename P::Design::template Checker<Word>;
  return P::Design::shaped(p, [&](auto of) {
    using M = typename decltype(of)::type;
    return record_of<Checker>(M::checker_of(work));
  });
}
template <class P>
requires IsShape<P> && HasWork<FirstOf<P>>
constexpr auto task_of(const P& p, const typename FirstOf<P>::Work& work) {
  using Task = typename P::Design::template Task<Word>;
  return P::Design::shaped(p, [&](auto of) {
    using M = typename decltype(of)::type;
    return record_of<Task>(M::job_of(work));
  });
}
template <class P>
requires IsShape<P> && HasWork<FirstOf<P>>
auto smaller(const P& p, const typename FirstOf<P>::Work& work) {
  return P::Design::shaped(p, [&](auto of) {
    using M = typename decltype(of)::type;
    return M::smaller(work);
  });
}
template <class P>
requires IsShape<P> && HasWork<FirstOf<P>> std::string describe(
    const P& p, const typename FirstOf<P>::Work& work) {
  return P::Design::shaped(p, [&](auto of) {
    using M = typename decltype(of)::type;
    return M::describe(work);
  });
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
