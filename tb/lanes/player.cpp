// Words of random bits, one a case, become planes, one a bit: a square of 64 by 64 bits is turned
// by halves, quarters and so on (Hacker's Delight, transposing a bit matrix).
#include "tb/lanes/player.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <new>

#include "tb/sim/hostile.h"

namespace cosim::lanes {
namespace {

using Square = std::array<std::uint64_t, 64>;

// Bit c of word r and bit r of word c change places: by halves, quarters and so on.
void turn(Square& square) {
  std::uint64_t mask = 0x00000000ffffffffULL;
  for (std::size_t half = 32; half != 0; half /= 2, mask ^= mask << half) {
    for (std::size_t i = 0; i < 64; i = (i + half + 1) & ~half) {
      const std::uint64_t t = (square[i] >> half ^ square[i + half]) & mask;
      square[i] ^= t << half;
      square[i + half] ^= t;
    }
  }
}

}  // namespace

void Player::Free::operator()(std::uint64_t* memory) const { std::free(memory); }

Player::Player(const Built& built, const AnyBench& bench)
    : built_(built),
      bench_(bench),
      words_(static_cast<std::size_t>(built.lanes) / 64),
      seeds_(
          static_cast<std::size_t>(std::ranges::count(built.layout.planes, Layout::First::seed))),
      left_out_(built.layout.counters) {
  constexpr std::size_t line = 64;
  const std::size_t bytes = (built.layout.planes.size() + 2) * words_ * sizeof(std::uint64_t);
  memory_.reset(
      static_cast<std::uint64_t*>(std::aligned_alloc(line, (bytes + line - 1) / line * line)));
  if (!memory_) throw std::bad_alloc();
}

std::uint64_t& Player::word(std::size_t plane, std::size_t lane) const {
  return memory_[plane * words_ + lane / 64];
}
bool Player::bit(std::size_t plane, std::size_t lane) const {
  return (word(plane, lane) >> (lane % 64) & 1) != 0;
}
void Player::flip(std::size_t plane, std::size_t lane) {
  word(plane, lane) ^= std::uint64_t{1} << (lane % 64);
}

// A lane without a case has seeds, too: a generator must not stand at 0.
void Player::put_seeds(std::uint64_t seed, std::uint64_t first) {
  const std::size_t each = seeds_ / 64;
  std::vector<Square> squares(each);
  for (std::size_t w = 0; w < words_; ++w) {
    for (std::size_t lane = 0; lane < 64; ++lane) {
      const std::uint64_t index = first + w * 64 + lane;
      std::size_t i = 0;
      HostileCase{seed, index}.seeds(each, [&](std::uint64_t s) { squares[i++][lane] = s; });
    }
    for (std::size_t i = 0; i < each; ++i) {
      turn(squares[i]);
      for (std::size_t b = 0; b < 64; ++b) memory_[(i * 64 + b) * words_ + w] = squares[i][b];
    }
  }
}

void Player::begin(std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
  put_seeds(seed, first);
  const auto& planes = built_.layout.planes;
  for (std::size_t i = seeds_; i < planes.size(); ++i) {
    std::uint64_t* plane = &memory_[i * words_];
    if (planes[i] == Layout::First::anything) {
      // As random as the seeds are; each case has others.
      std::copy_n(&memory_[i % seeds_ * words_], words_, plane);
    } else {
      std::fill_n(plane, words_, planes[i] == Layout::First::yes ? ~std::uint64_t{0} : 0);
    }
  }
  std::fill_n(&memory_[planes.size() * words_], words_, ~std::uint64_t{0});
  work_below(count);
  std::fill(left_out_.begin(), left_out_.end(), 0);
  clock_ = 0;
  built_.reset(memory_.get());
  if (!is_reset()) {
    // What is left of the power-up is to be that of the same case in the Verilated class.
    for (std::size_t lane = 0; lane < count; ++lane) {
      put_registers(built_.layout, memory_.get(), words_, lane,
                    bench_.begun(HostileCase{seed, first + lane}.power_up()));
    }
  }
  built_.take_over(memory_.get());
}

// Whether all registers hold the same in all lanes, which were powered up at random.
bool Player::is_reset() const {
  for (const auto& planes : built_.layout.registers) {
    for (const std::size_t plane : planes) {
      if (plane == Layout::none) continue;
      const std::uint64_t first = bit(plane, 0) ? ~std::uint64_t{0} : 0;
      for (std::size_t w = 0; w < words_; ++w) {
        if (memory_[plane * words_ + w] != first) return false;
      }
    }
  }
  return true;
}

void Player::work_below(std::size_t lane) {
  std::uint64_t* at_work = &memory_[built_.layout.planes.size() * words_];
  for (std::size_t w = 0; w < words_; ++w) {
    if (lane < 64 * (w + 1)) at_work[w] &= lane <= 64 * w ? 0 : ~(~std::uint64_t{0} << (lane % 64));
  }
}

std::optional<Player::Differs> Player::run(std::uint64_t to) {
  const std::size_t planes = built_.layout.planes.size();
  const std::uint64_t* at_work = &memory_[planes * words_];
  std::uint64_t* differ = &memory_[(planes + 1) * words_];
  const std::int64_t clock =
      built_.run(memory_.get(), at_work, clock_, to, differ, left_out_.data());
  if (clock < 0) {
    clock_ = std::max(clock_, to);
    return {};
  }
  clock_ = static_cast<std::uint64_t>(clock) + 1;
  for (std::size_t w = 0; w < words_; ++w) {
    if (differ[w] != 0) {
      return Differs{64 * w + static_cast<std::size_t>(std::countr_zero(differ[w])),
                     static_cast<std::uint64_t>(clock)};
    }
  }
  return {};
}

}  // namespace cosim::lanes
