// Hostile cases, one a lane, clock by clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tb/lanes/built.h"
#include "tb/sim/bench.h"

namespace cosim::lanes {

/// One thread's. `built`, the lanes of the bench's RTL, and `bench` must outlive it.
class Player {
 public:
  Player(const Built& built, const AnyBench& bench);

  /// Begins cases number first .. first + count - 1 of a seed, in lanes 0, 1 ...; 1 <= count <=
  /// built.lanes. All of them are at work then.
  void begin(std::uint64_t seed, std::uint64_t first, std::uint64_t count);
  /// Lanes from this one up are no longer at work: what they do is not compared.
  void work_below(std::size_t lane);

  struct Differs {
    std::size_t lane = 0;  ///< the lowest of those at work that differ then
    std::uint64_t clock = 0;
  };
  /// Goes on up to clock number `to`, which is not run, or through the first clock on which a lane
  /// at work differs.
  std::optional<Differs> run(std::uint64_t to);

  /// Of each register, then of each output, on how many clocks of lanes at work it was left out
  /// since the beginning; may be empty.
  const std::vector<std::uint64_t>& left_out() const { return left_out_; }
  /// The bit of a plane in a lane, before the next clock; and turns it over.
  bool bit(std::size_t plane, std::size_t lane) const;
  void flip(std::size_t plane, std::size_t lane);

 private:
  std::uint64_t& word(std::size_t plane, std::size_t lane) const;
  void put_seeds(std::uint64_t seed, std::uint64_t first);
  bool is_reset() const;

  struct Free {
    void operator()(std::uint64_t* memory) const;
  };
  const Built& built_;
  const AnyBench& bench_;
  std::size_t words_;                              // a plane
  std::size_t seeds_;                              // planes
  std::unique_ptr<std::uint64_t[], Free> memory_;  // the planes, then who is at work, who differs
  std::uint64_t clock_ = 0;
  std::vector<std::uint64_t> left_out_;
};

/// The first so many lanes go on up to this clock, which is not run. Each part of a play has no
/// more lanes than the one before, and none above one that differs.
struct Part {
  std::uint64_t lanes, to;
};
struct Outcome {
  std::optional<Player::Differs> differs;  ///< the lowest lane that does, and its first such clock
  std::vector<std::uint64_t> left_out;     ///< as of a Player
};

}  // namespace cosim::lanes
