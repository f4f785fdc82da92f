// Hostile stimulus: any value on any pin on any clock, resets too, but for inputs that the design
// says never come. Made from a design's field table alone, so it fits every design.
#pragma once

#include <array>
#include <cstdint>

#include "model/core/design.h"
#include "model/core/fields.h"
#include "model/core/reset.h"
#include "tb/stimulus/legal.h"
#include "tb/support/random.h"

namespace cosim {

/// One reproducible run of hostile clocks.
struct HostileCase {
  std::uint64_t seed = 1;
  std::uint64_t index = 0;  ///< the case's number under its seed
  std::uint64_t clocks = 1000;

  /// The power-up state of the case's machine.
  std::uint32_t power_up() const {
    return static_cast<std::uint32_t>(Random::for_case(~seed, index).next());
  }
};

/// Each pin leaves its resting level with a probability of its own, 1 to 2^-10, drawn anew every
/// few hundred clocks: so that some stretches reset on every clock and in others a line or an arc
/// runs long enough to be disturbed. In half of the stretches the design's reset is never asked
/// for. Wide pins take corner values, and may hold them for a stretch; so do arrays, each element
/// and the whole.
template <class Design>
class HostileStimulus {
 public:
  using Inputs = typename Design::template Inputs<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  using Params = typename Design::Params;
  using State = typename Design::template State<Word>;

  HostileStimulus(const typename Design::Params& p, const HostileCase& c)
      : fields_(Inputs::fields(p)), random_(Random::for_case(c.seed, c.index)), left_(c.clocks) {}

  bool next(Inputs& in, const Outputs&) {
    if (!more()) return false;
    draw(in);
    return true;
  }

  /// The same for a design that states which inputs are legal in the model's state s: draws again,
  /// and at last takes of what was drawn only the pins that leave its inputs at rest legal.
  /// InputError where those are not.
  bool next_legal(const Params& p, const State& s, Inputs& in) {
    if (!more()) return false;
    for (int i = 0; i < tries; ++i) {
      draw(in);
      if (broken_rule<Design>(p, s, in) == nullptr) return true;
    }
    mend(p, s, in);
    return true;
  }

 private:
  static constexpr std::uint64_t stretch = 256;
  static constexpr int never = 64;
  static constexpr int tries = 4;

  bool more() {
    if (left_ == 0) return false;
    if (left_-- % stretch == 0 || first_) redraw();
    first_ = false;
    return true;
  }

  void draw(Inputs& in) {
    in = rest_;
    for_each_member<Inputs>([&](auto member, std::size_t i) { draw_pin(in.*member, member, i); });
  }

  static void mend(const Params& p, const State& s, Inputs& in) {
    const Inputs drawn = in;
    in = idle_of<Design, Word>(p, s);
    if (const char* rule = broken_rule<Design>(p, s, in)) {
      throw InputError(std::string(Design::name) +
                       ": its inputs at rest break a rule of its own in a state that it reaches; " +
                       "idle(p, s) is to give legal ones. The rule is: " + rule);
    }
    // One pin may be legal only beside another one: hence twice.
    for (int pass = 0; pass < 2; ++pass) {
      for_each_member<Inputs>([&](auto member, std::size_t) {
        Inputs tried = in;
        tried.*member = drawn.*member;
        if (broken_rule<Design>(p, s, tried) == nullptr) in = tried;
      });
    }
  }

  void draw_pin(Word& pin, Word Inputs::*member, std::size_t i) {
    if (fields_[i].width > 1) {
      if (happens(i)) held_.*member = random_.corner(range(fields_[i]));
      pin = held_.*member;
    } else if (happens(i)) {
      pin = 1 - rest_.*member;
    }
  }
  /// An array takes corners as a whole, all 0 or all 1, or in each element; or one element changes.
  template <int N>
  void draw_pin(Array<Word, N>& pins, Array<Word, N> Inputs::*member, std::size_t first) {
    if (happens(first)) {
      const Field* fields = &fields_[first];
      const std::uint64_t how = random_.below(8);
      const auto one = static_cast<int>(random_.below(N));
      for (int k = 0; k < N && fields[k].width != 0; ++k) {
        Word& pin = (held_.*member)[k];
        if (how < 2) {
          pin = how == 0 ? 0 : ones(fields[k].width);
        } else if (how > 3 || k == one) {
          pin = random_.corner(range(fields[k]));
        }
      }
    }
    pins = held_.*member;
  }

  /// The bits that a value is drawn from: half of a signed field's values are >= 0, for the ends of
  /// the numbers that it counts up and down through are not those of its codes.
  int range(const Field& field) {
    return is_signed(field) && random_.one_in_power(1) ? field.width - 1 : field.width;
  }

  bool happens(std::size_t i) { return rarity_[i] != never && random_.one_in_power(rarity_[i]); }

  static bool same(Word a, Word b) { return a == b; }
  template <int N>
  static bool same(const Array<Word, N>& a, const Array<Word, N>& b) {
    return a.elements == b.elements;
  }

  void redraw() {
    const bool quiet = random_.one_in_power(1);
    Inputs clear = rest_;
    if constexpr (has_clear<Design>) clear = Design::clear();
    for_each_member<Inputs>([&](auto member, std::size_t i) {
      rarity_[i] = static_cast<int>(random_.below(11));
      if (quiet && !same(clear.*member, rest_.*member)) rarity_[i] = never;
    });
  }

  std::array<Field, Inputs::size> fields_;
  Random random_;
  std::uint64_t left_;
  Inputs rest_ = rest_of<Design>();
  Inputs held_{};
  std::array<int, Inputs::size> rarity_{};
  bool first_ = true;
};

}  // namespace cosim
