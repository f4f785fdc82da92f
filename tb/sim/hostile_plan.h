// Which random bits hostile stimulus takes for what. A case has words of 64 random bits, new ones
// on every clock, and others of which there are new ones in every stretch of clocks; the plan gives
// each pin its own of both. It follows from the design's field table alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "model/core/design.h"
#include "model/core/fields.h"
#include "model/core/reset.h"
#include "tb/sim/legal.h"

namespace cosim {

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

}  // namespace cosim
