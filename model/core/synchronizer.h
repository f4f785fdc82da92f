// Metastability. The first register of a synchronizer samples what another clock changes. Where
// both clocks take their edge on one step, it may take the old value or the new one, each bit for
// itself: the new one is what it takes if its own clock comes a moment behind the others. An input
// of the model that is no pin says which bits take the new one (Sampled in model/clocked/fields.h);
// it is drawn and kept as the others are, so that a step stays a function of its inputs. It matters
// where what is sampled changes on the step, and nowhere else.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

#include "model/core/design.h"
#include "model/core/input_error.h"
#include "model/core/reset.h"

namespace cosim {

/// How many of the inputs are of a synchronizer.
template <class Design>
inline constexpr int synchronizers_of = 0;
template <class Design>
requires requires { typename Design::template Inputs<Word>; }
inline constexpr int synchronizers_of<Design> = Design::template Inputs<Word>::Table::choices;

template <class Design>
class Synchronizers {
  template <class V>
  using State = typename Design::template State<V>;
  template <class V>
  using Inputs = typename Design::template Inputs<V>;

 public:
  static constexpr bool any = synchronizers_of<Design> != 0;
  static_assert(!any || clocks_of<Design> != 0, "synchronizer() is for a design of several clocks");

  /// InputError where such an input names no field of the state that is a code of its width.
  constexpr explicit Synchronizers(const typename Design::Params& p) {
    if constexpr (any) {
      const auto inputs = Inputs<Word>::fields(p);
      const auto state = State<Word>::fields(p);
      std::size_t n = 0, clocks = 0;
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (inputs[i].edge != Edge::none) clocks_[clocks++] = i;
        if (inputs[i].synchronizer == nullptr) continue;
        std::size_t k = 0;
        while (k < state.size() && std::string_view(state[k].name) != inputs[i].synchronizer) ++k;
        if (k == state.size() || state[k].index >= 0 || is_signed(state[k]) ||
            state[k].width != inputs[i].width) {
          throw InputError(std::string(Design::name) + ": input " + inputs[i].name +
                           ": the state has no " + inputs[i].synchronizer + " of " +
                           std::to_string(inputs[i].width) + " bits");
        }
        all_[n++] = {i, k};
      }
    }
  }

  /// The state s after a step that came from `before` with these inputs, where those bits have
  /// taken the new value. A register of another clock than the one that comes last has it already.
  template <class V>
  constexpr State<V> taken(const typename Design::Params& p, const State<V>& before,
                           const Inputs<V>& in, const State<V>& s) const {
    State<V> after = s;
    if constexpr (any) {
      if (!matters(in)) return after;
      for (const std::size_t last : clocks_) {
        Inputs<V> others = in, alone = in;
        put<V>(others, last, V(0));
        for (const std::size_t clock : clocks_) {
          if (clock != last) put<V>(alone, clock, V(0));
        }
        const State<V> first = clock_of<Design, V>(p, before, others).state;
        const State<V> then = clock_of<Design, V>(p, first, alone).state;
        for (const One& one : all_) {
          const V turned = at<V>(in, one.choice) & (at<V>(then, one.held) ^ at<V>(s, one.held));
          put<V>(after, one.held, at<V>(after, one.held) ^ turned);
        }
      }
    }
    return after;
  }

 private:
  struct One {
    std::size_t choice, held;  ///< cells of the inputs and of the state
  };

  template <class V, class Record>
  static constexpr V at(const Record& r, std::size_t cell) {
    V value{};
    for_each_cell<Record>([&](auto of, std::size_t i) {
      if (i == cell) value = of(r);
    });
    return value;
  }
  template <class V, class Record>
  static constexpr void put(Record& r, std::size_t cell, const V& value) {
    for_each_cell<Record>([&](auto of, std::size_t i) {
      if (i == cell) of(r) = value;
    });
  }
  // Whether two clocks take their edge, and a bit is to take the new value; true of what is not
  // known.
  template <class V>
  constexpr bool matters([[maybe_unused]] const Inputs<V>& in) const {
    if constexpr (std::is_same_v<V, Word>) {
      Word chosen = 0, edges = 0;
      for (const One& one : all_) chosen |= at<Word>(in, one.choice);
      for (const std::size_t clock : clocks_) edges += at<Word>(in, clock);
      return chosen != 0 && edges > 1;
    } else {
      return true;
    }
  }

  std::array<One, static_cast<std::size_t>(synchronizers_of<Design>)> all_{};
  std::array<std::size_t, static_cast<std::size_t>(clocks_of<Design>)>
      clocks_{};  // cells of inputs
};

}  // namespace cosim
