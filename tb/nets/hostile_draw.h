// Hostile stimulus as a step function over a value type: on machine integers it is the stimulus of
// one case, on bits of gates that of many cases at a time. So a case is the same in both.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "model/core/design.h"
#include "model/core/fields.h"
#include "model/core/reset.h"
#include "model/core/value.h"
#include "tb/nets/legal.h"
#include "tb/util/random.h"

namespace cosim {

// Which random bits hostile stimulus takes for what. A case has words of 64 random bits, new ones
// on every clock, and others of which there are new ones in every stretch of clocks; the plan gives
// each pin its own of both. It follows from the design's field table alone.

/// Some bits of the random words; of none, width 0.
struct RandomBits {
  int word = 0, low = 0, width = 0;
};

/// Gives out the bits of words one after the other, each once.
template <std::size_t most>
class RandomBitsLeft {
 public:
  /// So many bits of one word, 1 to 64.
  constexpr RandomBits take(int width) {
    int word = 0;
    while (used_[static_cast<std::size_t>(word)] + width > 64) ++word;
    return take(width, word);
  }
  /// Of this word, which has so many left.
  constexpr RandomBits take(int width, int word) {
    int& used = used_[static_cast<std::size_t>(word)];
    words_ = std::max(words_, word + 1);
    used += width;
    return {word, used - width, width};
  }
  constexpr int left(int word) const { return 64 - used_[static_cast<std::size_t>(word)]; }
  /// How many words bits were taken of.
  constexpr int words() const { return words_; }

 private:
  std::array<int, most> used_{};
  int words_ = 0;
};

template <class Design>
struct HostilePlan {
  using Inputs = typename Design::template Inputs<Word>;

  /// Words are at least half used, and a cell takes at most 64 + 3 + 5 bits of those of a clock and
  /// 14 of those of a stretch; a clock takes 3 + 7.
  static constexpr std::size_t most_words = 3 * Inputs::size + 3;
  static constexpr std::size_t most_stretch_words = Inputs::size / 2 + 2;

  static constexpr std::size_t groups = 4;  ///< of bits that pins share, in a word

  /// A field: a pin, or an array of them, which changes at one time.
  struct Pin {
    std::size_t first = 0, cells = 0;
    bool is_array = false;
    bool is_wide = false;     ///< it takes values, and is not only at rest or not
    bool is_quiet = false;    ///< it is among those that reset the design
    bool is_clock = false;    ///< 1 where registers take its edge
    Word rest = 0;            ///< of one that is not wide
    RandomBits own;           ///< of a clock: 3 that must be 0 for it to change, or fewer of them
    std::size_t shared = 0;   ///< of a clock: which of `shared` must be, too, or
    std::size_t rarely = 0;   ///< this one besides
    RandomBits corner;        ///< of a clock: a corner value, and on which side
    RandomBits whole;         ///< of a clock, of an array: all elements change
    RandomBits rarity;        ///< of a stretch: how many of these
    RandomBits kind, place;   ///< of a stretch: the corner
    RandomBits is_sign_free;  ///< of a stretch, of a signed pin: its first bit is in no corner
    RandomBits is_slow;       ///< of a stretch, of a clock: its edge is what is rare
    RandomBits toggles;       ///< of a stretch, of a clock: what is rare begins and ends its edges
    /// How many bits its rarity is held in: one stands for "never".
    constexpr int rarity_width() const { return is_quiet ? 6 : 5; }
  };
  struct Cell {
    int width = 0;
    RandomBits low, high;  ///< of a clock: its value
    RandomBits some;       ///< of a clock, of an element: it changes where they are 0
  };

  std::array<Pin, Inputs::size> pins{};
  std::size_t pin_count = 0;
  std::array<Cell, Inputs::size> cells{};
  /// Of a clock: 4 bits for several pins together.
  std::array<RandomBits, groups * Inputs::size> shared{};
  std::size_t shared_count = 0;
  RandomBits quiet;  ///< of a stretch: the design is not reset in it
  std::size_t words = 0, stretch_words = 0;

  explicit constexpr HostilePlan(const typename Design::Params& p) {
    const auto fields = Inputs::fields(p);
    RandomBitsLeft<most_words> clock;
    RandomBitsLeft<most_stretch_words> stretch;
    quiet = stretch.take(1);
    Inputs reset = rest_of<Design>();
    if constexpr (has_reset<Design>) reset = reset_inputs_of<Design>();
    const auto held = to_words(reset), at_rest = to_words(rest_of<Design>());
    for (std::size_t i = 0; i < fields.size();) {
      Pin& pin = pins[pin_count++];
      pin.first = i;
      const bool is_array = fields[i].index >= 0;
      do {
        cells[i].width = fields[i].width;
        pin.is_quiet = pin.is_quiet || held[i] != at_rest[i];
        ++i;
      } while (i < fields.size() && fields[i].index > 0);
      pin.cells = i - pin.first;
      pin.rest = at_rest[pin.first];
      pin.is_clock = fields[pin.first].edge != Edge::none;
      pin.is_wide = is_array || fields[pin.first].width > 1;
      pin.is_array = is_array;
      take_event(pin, clock);
      pin.rarity = stretch.take(5);
      if (pin.is_clock) {
        pin.is_slow = stretch.take(1);
        pin.toggles = stretch.take(1);
      }
    }
    for (std::size_t n = 0; n < pin_count; ++n) {
      if (!pins[n].is_wide) continue;
      take_values(pins[n], clock);
      take_corner(pins[n], fields[pins[n].first], stretch);
    }
    words = static_cast<std::size_t>(clock.words());
    stretch_words = static_cast<std::size_t>(stretch.words());
  }

 private:
  static constexpr int in_piece = 32;

  // Beside the bits that it shares, so that one word decides. Pins that share are few, for what is
  // rare is to come alone, too.
  constexpr void take_event(Pin& pin, RandomBitsLeft<most_words>& clock) {
    const int needed = pin.is_wide ? 5 : 3;
    if (shared_count == 0 || clock.left(shared[shared_count - 1].word) < needed) {
      const int word = clock.words();
      for (std::size_t i = 0; i < groups; ++i) shared[shared_count++] = clock.take(4, word);
    }
    pin.shared = shared_count - groups + pin_count % groups;
    pin.rarely = shared_count - groups + (pin_count + 1) % groups;
    const int word = shared[pin.shared].word;
    pin.own = clock.take(3, word);
    if (pin.is_wide) pin.corner = clock.take(2, word);
  }
  constexpr void take_values(Pin& pin, RandomBitsLeft<most_words>& clock) {
    if (pin.is_array) pin.whole = clock.take(1);
    for (std::size_t k = pin.first; k < pin.first + pin.cells; ++k) {
      Cell& cell = cells[k];
      if (cell.width == 0) continue;
      cell.low = clock.take(std::min(cell.width, in_piece));
      if (cell.width > in_piece) cell.high = clock.take(cell.width - in_piece);
      if (pin.is_array) cell.some = clock.take(3);
    }
  }
  static constexpr void take_corner(Pin& pin, const Field& field,
                                    RandomBitsLeft<most_stretch_words>& stretch) {
    int bits = 1;
    while ((1 << bits) < field.width) ++bits;
    pin.kind = stretch.take(2);
    pin.place = stretch.take(bits);
    if (is_signed(field)) pin.is_sign_free = stretch.take(1);
  }
};

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
