// The sweeps that run in lanes, where that is asked for or worth it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "tb/lanes/built.h"
#include "tb/sweep/sweep.h"

namespace cosim::cli {

/// How many lanes --lanes asks for, 0: none; nothing: what is better. InputError for anything else.
std::optional<int> lanes_asked(const std::optional<std::string>& text);

/// A sweep of a bench, in lanes or one case at a time.
class InLanes {
 public:
  /// `clocks` of a sweep that is of hostile ones, 0 of another; `lanes` as --lanes has it. Prints a
  /// line where lanes would be better and are not to be had. InputError where they were asked for.
  InLanes(const AnyBench& bench, const Sweep& sweep, std::uint64_t seed, std::uint64_t clocks,
          const std::optional<std::string>& lanes);
  /// In the widest lanes of the folder `prepared` that this processor runs; one case at a time
  /// where there are none.
  InLanes(const AnyBench& bench, const Sweep& sweep, std::uint64_t seed, std::uint64_t clocks,
          const std::filesystem::path& prepared);
  /// As long as this object lives.
  const Sweep& sweep() const { return sweep_; }

 private:
  void take(const AnyBench& bench, std::uint64_t seed, std::uint64_t clocks);

  std::unique_ptr<lanes::Built> built_;
  Sweep sweep_;
};

/// Makes in the folder `prepared` the lanes that InLanes takes there, for this processor, or for
/// any that has vectors no wider. Hostile clocks get them where they are worth it, jobs where they
/// are `asked` for. InputError where what is asked for is not to be had.
void prepare_lanes(const AnyBench& bench, const Sweep& sweep, std::uint64_t clocks, bool asked,
                   bool for_any, const std::filesystem::path& prepared);

}  // namespace cosim::cli
