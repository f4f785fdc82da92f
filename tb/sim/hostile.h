// Hostile stimulus: any value on any pin on any clock, resets too, but for inputs that the design
// says never come. Made from a design's field table alone, so it fits every design.
#pragma once

#include <cstdint>
#include <string>

#include "model/core/design.h"
#include "model/core/input_error.h"
#include "tb/nets/hostile_draw.h"
#include "tb/nets/legal.h"
#include "tb/util/random.h"

namespace cosim {

/// One reproducible run of hostile clocks.
struct HostileCase {
  /// In so many clocks each pin behaves as one drawing at their beginning says.
  static constexpr std::uint64_t stretch = 256;

  std::uint64_t seed = 1;
  std::uint64_t index = 0;      ///< the case's number under its seed
  std::uint64_t clocks = 1000;  ///< a case of fewer clocks is the beginning of one of more

  /// The power-up state of the case's machine.
  std::uint32_t power_up() const {
    return static_cast<std::uint32_t>(Random::for_case(~seed, index).next());
  }
  /// What its random words start from: calls put(word) for so many of them.
  template <class Put>
  void seeds(std::size_t words, Put put) const {
    Random random = Random::for_case(seed, index);
    for (std::size_t i = 0; i < words; ++i) {
      const std::uint64_t word = random.next();
      put(word == 0 ? 1 : word);
    }
  }
};

/// Each pin leaves its resting level with a probability of its own, 1 to 2^-11, drawn anew every
/// few hundred clocks: so that some stretches reset on every clock and in others a line or an arc
/// runs long enough to be disturbed. In half of the stretches the design's reset is never asked
/// for. What is rare comes together more often than by chance. Wide pins hold their value until
/// they take another, any or, as often, a corner of the stretch: 0 or all ones, a small number or
/// one turned over, a single bit or all but one; of a signed pin in half of the stretches without
/// its sign, for the ends of the numbers that it counts up and down through are not those of its
/// codes. So do arrays, each element and the whole. A clock, of several, takes its edge nearly
/// always in one stretch, seldom in another, by turns or for some clocks on end in a third, or
/// never.
template <class Design>
class HostileStimulus {
 public:
  using Inputs = typename Design::template Inputs<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  using Params = typename Design::Params;
  using State = typename Design::template State<Word>;

  HostileStimulus(const Params& p, const HostileCase& c) : plan_(p), clocks_(c.clocks) {
    std::size_t i = 0;
    c.seeds(plan_.words + plan_.stretch_words, [&](std::uint64_t word) {
      const std::size_t at = i++;
      (at < plan_.words ? held_.words[at] : held_.stretch_words[at - plan_.words]) =
          static_cast<Word>(word);
    });
  }

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
  static constexpr int tries = 4;

  using Draw = HostileDraw<Design, Word>;

  bool more() {
    if (clock_ == clocks_) return false;
    if (clock_++ % HostileCase::stretch == 0) Draw::begin_stretch(plan_, held_);
    return true;
  }

  void draw(Inputs& in) { Draw::clock(plan_, held_, in); }

  static void mend(const Params& p, const State& s, Inputs& in) {
    const Inputs drawn = in;
    in = idle_of<Design, Word>(p, s);
    if (const char* rule = broken_rule<Design>(p, s, in)) {
      throw InputError(
          std::string(Design::name) +
          ": rest() breaks an assumption in a state that is reached; idle() must return "
          "legal inputs. The assumption is: " +
          rule);
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

  HostilePlan<Design> plan_;
  typename Draw::Held held_{};
  std::uint64_t clock_ = 0, clocks_;
};

}  // namespace cosim
