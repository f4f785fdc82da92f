// Hostile stimulus as a step function over a value type: on machine integers it is the stimulus of
// one case, on bits of gates that of many cases at a time. So a case is the same in both.
#pragma once

#include <array>
#include <cstddef>

#include "model/core/value.h"
#include "tb/sim/hostile_plan.h"
#include "tb/util/random.h"

namespace cosim {

/// The next word of an xorshift generator, which goes through all words but 0. Its bits are sums of
/// at least three of the last word's.
template <class V>
constexpr V xorshift(V x) {
  x = x ^ low_bits(shift_right(x, 23), 64 - 23);
  x = x ^ shift_left(x, 41);
  return x ^ low_bits(shift_right(x, 18), 64 - 18);
}

template <class Design, class V>
class HostileDraw {
 public:
  using Plan = HostilePlan<Design>;
  using Inputs = typename Design::template Inputs<V>;

  /// What it goes on from. As bits it has those of `visit_held`.
  struct Held {
    std::array<V, Plan::most_words> words;
    std::array<V, Plan::most_stretch_words> stretch_words;
    std::array<V, Inputs::size> rarity;  ///< a pin each: the bits that must be 0 for it to change
    std::array<V, Inputs::size> corner;  ///< a cell each: the bits that a corner value fills
    std::array<V, Inputs::size> value;   ///< a cell each of a wide pin, and of a clock
  };

  /// Calls visit(value, width) for each value of `held` that the plan has, in a fixed order; the
  /// random words come first.
  template <class SomeHeld, class Visit>
  static constexpr void visit_held(const Plan& plan, SomeHeld& held, Visit visit) {
    for (std::size_t i = 0; i < plan.words; ++i) visit(held.words[i], 64);
    for (std::size_t i = 0; i < plan.stretch_words; ++i) visit(held.stretch_words[i], 64);
    for (std::size_t n = 0; n < plan.pin_count; ++n) {
      const auto& pin = plan.pins[n];
      visit(held.rarity[n], pin.rarity_width());
      if (pin.is_clock) visit(held.value[pin.first], 1);
      if (!pin.is_wide) continue;
      for (std::size_t k = pin.first; k < pin.first + pin.cells; ++k) {
        if (plan.cells[k].width == 0) continue;
        visit(held.corner[k], plan.cells[k].width);
        visit(held.value[k], plan.cells[k].width);
      }
    }
  }

  /// To be called before the first clock of a stretch.
  static constexpr void begin_stretch(const Plan& plan, Held& held) {
    for (std::size_t i = 0; i < plan.stretch_words; ++i) {
      held.stretch_words[i] = xorshift(held.stretch_words[i]);
    }
    const auto bits = [&](const RandomBits& b) { return taken(held.stretch_words, b); };
    const auto quiet = bit(bits(plan.quiet), 0);
    for (std::size_t n = 0; n < plan.pin_count; ++n) {
      const auto& pin = plan.pins[n];
      const V rarity = bits(pin.rarity);
      const V own = low_bits(rarity, 2), shared = shift_right(rarity, 2);
      held.rarity[n] = (shift_left(V(1), own) - V(1)) | select(shared > V(2), V(8), V(0)) |
                       select(shared > V(5), V(16), V(0));
      if (pin.is_clock) {  // that none moves is to be rare
        const auto is_still = bit(bits(pin.is_slow), 0) | bit(bits(pin.toggles), 0);
        held.rarity[n] = held.rarity[n] & select(is_still, V(15), V(31));
      }
      if (pin.is_quiet) held.rarity[n] = held.rarity[n] | select(quiet, V(32), V(0));
      if (!pin.is_wide) continue;
      for (std::size_t k = pin.first; k < pin.first + pin.cells; ++k) {
        const int width = plan.cells[k].width;
        if (width == 0) continue;
        held.corner[k] = corner(width, bits(pin.kind), bits(pin.place));
        if (pin.is_sign_free.width == 0 || width == 1) continue;
        const V below_sign = V(ones(width - 1));
        held.corner[k] =
            select(bit(bits(pin.is_sign_free), 0), held.corner[k] & below_sign, held.corner[k]);
      }
    }
  }

  /// The inputs of a clock.
  static constexpr void clock(const Plan& plan, Held& held, Inputs& in) {
    for (std::size_t i = 0; i < plan.words; ++i) held.words[i] = xorshift(held.words[i]);
    const auto bits = [&](const RandomBits& b) { return taken(held.words, b); };
    std::array<V, Plan::groups * Inputs::size> in_the_way;
    for (std::size_t i = 0; i < plan.shared_count; ++i) {
      in_the_way[i] = select(bits(plan.shared[i]) == V(0), V(0), V(8));
    }
    const auto changes = [&](std::size_t n) {
      const auto& pin = plan.pins[n];
      const V all =
          bits(pin.own) | in_the_way[pin.shared] | shift_left(in_the_way[pin.rarely], 1) | V(32);
      return (all & held.rarity[n]) == V(0);
    };
    std::size_t n = 0;
    for_each_member<Inputs>([&](auto member, std::size_t) {
      const auto& pin = plan.pins[n];
      const auto changed = changes(n);
      std::size_t k = pin.first;
      if (pin.is_wide) {
        change(plan, pin, changed, held);
        for_each_value(in.*member, [&](V& value) { value = held.value[k++]; });
      } else if (pin.is_clock) {
        held.value[k] = clocks(pin, changed, held);
        for_each_value(in.*member, [&](V& value) { value = held.value[k]; });
      } else {
        for_each_value(in.*member,
                       [&](V& value) { value = select(changed, V(1 - pin.rest), V(pin.rest)); });
      }
      ++n;
    });
  }

 private:
  /// Whether a clock takes its edge: seldom or nearly always, for some clocks on end, or by turns.
  static constexpr V clocks(const typename Plan::Pin& pin, const Condition<V>& changed,
                            const Held& held) {
    const auto is = [&](const RandomBits& b) { return bit(taken(held.stretch_words, b), 0); };
    const V now = select(changed, V(1), V(0));
    const V other = V(1) - now;
    const V turned = select(changed, V(1) - held.value[pin.first], held.value[pin.first]);
    return select(is(pin.toggles), turned, select(is(pin.is_slow), now, other));
  }

  template <class Words>
  static constexpr V taken(const Words& words, const RandomBits& b) {
    return low_bits(shift_right(words[static_cast<std::size_t>(b.word)], b.low), b.width);
  }

  /// Which bits a corner value of so many fills, all with the same: all of them, so that it is 0 or
  /// all ones; all but one; or those from one up, so that it is a small number or a small one
  /// turned over.
  static constexpr V corner(int width, const V& kind, const V& place) {
    const V all = V(ones(width));
    const V from = select(place > V(width - 1), place - V(width), place);
    const V one = low_bits(shift_left(V(1), from), width);
    const V above = low_bits(shift_left(all, from), width);
    return select(kind == V(0), all, select(kind == V(1), all ^ one, above));
  }

  /// New values of a wide pin: of an array all elements take one, or some of them do.
  static constexpr void change(const Plan& plan, const typename Plan::Pin& pin,
                               const Condition<V>& changed, Held& held) {
    const auto bits = [&](const RandomBits& b) { return taken(held.words, b); };
    for (std::size_t k = pin.first; k < pin.first + pin.cells; ++k) {
      const auto& cell = plan.cells[k];
      if (cell.width == 0) continue;
      Condition<V> takes = changed;
      if (pin.whole.width != 0) {
        takes = takes & (bit(bits(pin.whole), 0) | (bits(cell.some) == V(0)));
      }
      held.value[k] = if_else(
          takes,
          [&] {
            V uniform = bits(cell.low);
            if (cell.high.width != 0) {
              uniform = uniform | shift_left(bits(cell.high), cell.low.width);
            }
            const V filled = select(bit(bits(pin.corner), 0), held.corner[k], V(0));
            const V fill = select(bit(bits(pin.corner), 1), filled, V(0));
            return (uniform & (V(ones(cell.width)) ^ filled)) | fill;
          },
          [&] { return held.value[k]; });
    }
  }
};

}  // namespace cosim
