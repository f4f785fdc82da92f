// Values of a design that a wave shows beside its fields: its position, its phase in words. A
// design that has such values defines a View, and has a member type of that name:
//
//   class View {
//     /// The probes; the same on every clock.
//     static constexpr std::array<Probe, N> probes(const Params& p);
//     /// One clock: the state before it and the outputs during it.
//     void clock(const Params& p, const State<Word>& s, const Outputs<Word>& out);
//     /// The value of each probe on that clock.
//     std::array<Word, N> values() const;
//   };
//
// One View follows the model and one the RTL; both are given the model's state.
#pragma once

#include <array>
#include <span>
#include <type_traits>

#include "model/core/fields.h"

namespace cosim {

struct Probe {
  enum class Kind {
    number,
    analog,  ///< a number, drawn as a curve
    words,   ///< a number that selects a word of a list
  };
  /// Whose outputs it is computed from.
  enum class Side { both, expected, actual };

  const char* name;  ///< with a scope that no other probe of the design has
  Kind kind;
  const char* scope;                        ///< in the waveform it is cosim.SCOPE.NAME
  const char* group = "";                   ///< its title in a view; "" for none
  int width = 64;                           ///< bits, 1 to 64
  Format format = {};                       ///< of a number or a curve: how it is read
  Side side = Side::both;                   ///< of both, the model's is cosim.SCOPE.expected_NAME
  std::span<const char* const> words = {};  ///< by number, from 0
};

/// The view of a design that has none.
template <class Design>
class NoView {
 public:
  static constexpr std::array<Probe, 0> probes(const typename Design::Params&) { return {}; }
  void clock(const typename Design::Params&, const typename Design::template State<Word>&,
             const typename Design::template Outputs<Word>&) {}
  std::array<Word, 0> values() const { return {}; }
};

namespace detail {

template <class Design>
constexpr auto view_of() {
  if constexpr (requires { typename Design::View; }) {
    return std::type_identity<typename Design::View>{};
  } else {
    return std::type_identity<NoView<Design>>{};
  }
}

}  // namespace detail

/// The design's View, or one without probes.
template <class Design>
using ViewOf = typename decltype(detail::view_of<Design>())::type;

}  // namespace cosim
