// The language of golden models: a struct whose members are the registers, and one function that is
// a clock.
//
//   template <int D>               // the module's parameters, in their order
//   struct Blink {
//     struct In { Bit rst; };      // its ports, by their names in the RTL
//     struct Out { Bit led; };
//
//     UInt<8> count = 0;           // registers, by their names in the RTL, and their reset values
//     Bit on = 0;
//
//     Out clock(const In& in) {    // outputs before the edge; the members after it
//       const Out out{.led = on};
//       if (in.rst) {
//         count = 0;
//         on = 0;
//       } else if (count == D - 1) {
//         count = 0;
//         on = !on;
//       } else {
//         ++count;
//       }
//       return out;
//     }
//   };
//
// A design without registers has `Out clock(const In&) const`.
//
// The same source is compiled twice. In the simulator a value is an integer. In the exporter,
// another program, compiled with -DCOSIM_SYMBOLIC, it may be a symbol, which stands for any number:
// clock() is run once for each way through it (a symbol as the condition of if, while or ?: is a
// fork, both ways of which are run), and the results are joined into a graph, which export.h
// writes. Loops, early returns, helper functions and local bools are therefore those of C++.
// clock() may depend only on its members and on `in`.
//
//   value.h      UInt<W>, Int<W>, Bit: their bits, slices, conversions
//   operators.h  the widths of expressions; cat, mux, reduce_and, reduce_or, reduce_xor
//   fields.h     Array<T, N>, Unreset<T>, At<"path", T>, Auxiliary<T>, Hex<T>, Source<"7", T>,
//                OnesComplement<W>, OnesComplementCode<W>, Fraction<2, T>; Range<0, 9>; clocks:
//                Rises, Falls, Sampled<"register", T>
//   cells.h      the members of such a struct, for what works on any model
//   says.h       what a model may have beside its clock: reset, assumptions, cases, jobs
//
// `c ? a : b` wants a and b of one type, and forks; mux(c, a, b) takes any two, and does not.
#pragma once

#include <tuple>
#include <utility>
#ifdef COSIM_SYMBOLIC
#include <vector>
#endif

#include "model/clocked/cells.h"
#include "model/clocked/says.h"

namespace cosim::clocked {

/// merge(*this, [&] { ... }): runs the block. In the exporter the ways through it are joined at its
/// end, so that the code after it is not run once for each of them: for several blocks in a row
/// whose conditions do not depend on each other. The arguments before the block are all objects
/// that it changes: the model or some of its members, and locals, but no numbers of C++.
template <class... Words>
void merge(Words&&... words) {
  constexpr std::size_t n = sizeof...(Words) - 1;
  const auto all = std::forward_as_tuple(words...);
  auto& block = std::get<n>(all);
#ifdef COSIM_SYMBOLIC
  const auto each = [&](const auto& visit) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (for_each_cell(std::get<I>(all),
                     [&](const Label&, auto& cell) {
                       using B = Base<std::remove_reference_t<decltype(cell)>>;
                       visit(static_cast<B&>(cell));
                     }),
       ...);
    }
    (std::make_index_sequence<n>());
  };
  std::vector<Id> before;
  each([&](auto& cell) { before.push_back(Inside::node(cell)); });
  const auto set = [&](const std::vector<Id>& nodes) {
    std::size_t i = 0;
    each([&](auto& cell) {
      cell = Inside::of<std::remove_reference_t<decltype(cell)>>(nodes[i++]);
    });
  };
  set(ways.join([&] {
    set(before);
    block();
    std::vector<Id> nodes;
    each([&](auto& cell) { nodes.push_back(Inside::node(cell)); });
    return nodes;
  }));
#else
  block();
#endif
}

}  // namespace cosim::clocked
