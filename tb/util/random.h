// The random numbers of every stimulus: SplitMix64, whose stream for a seed is the same on every
// machine and standard library.
#pragma once

#include <cstdint>

#include "model/core/value.h"
#include "model/core/wide.h"

namespace cosim {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// The stream of one case of a run: independent of all other cases'.
  static Random for_case(std::uint64_t seed, std::uint64_t index) {
    Random mixer(seed ^ (index * 0x9e3779b97f4a7c15ULL + 0x632be59bd9b4e019ULL));
    return Random(mixer.next());
  }

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

  /// Uniform over 0 .. n - 1, n >= 1 (to within 2^-32 for n <= 2^32).
  std::uint64_t below(std::uint64_t n) {
    return static_cast<std::uint64_t>((static_cast<Uint128>(next()) * n) >> 64);
  }

  /// True with probability 2^-n.
  bool one_in_power(int n) { return n == 0 || (next() >> (64 - n)) == 0; }

  /// A number of `width` bits that is often an end of the range, small, or a single bit: where
  /// counters and carries have their corners.
  Word corner(int width) {
    const std::uint64_t r = next();
    const Word uniform = low_bits(static_cast<Word>(next()), width);
    // Without a jump, which nothing could predict: of 16 kinds the first two are 0, four more have
    // a single bit; seven shift that, or what is uniform, and four are inverted.
    const auto is = [kind = r & 15](unsigned kinds) {
      return static_cast<Word>(kinds >> kind & 1);
    };
    const auto bits = static_cast<std::uint64_t>(-is(0x07f0));
    const auto place = static_cast<int>((r >> 8) % static_cast<unsigned>(width) & bits);
    const Word value = shift_left(is(0x003c), place) | shift_right(uniform & -is(0xffc0), place);
    return low_bits(value ^ -is(0x042a), width);
  }

 private:
  std::uint64_t state_;
};

}  // namespace cosim
