// Hostile cases on a device of OpenCL: a thread has 32 lanes, and runs all clocks of its cases.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "tb/lanes/code.h"
#include "tb/lanes/opencl.h"
#include "tb/lanes/player.h"
#include "tb/sim/bench.h"

namespace cosim::lanes {

/// The kernels of a design, as a source of OpenCL C for any device:
///
///   begin(planes, threads, seed, first)            the cases from number `first` on, after reset
///   run(planes, threads, from, to, count, found, left_out)
///                                                  clocks from .. to - 1 of the first `count`
///                                                  lanes
///
/// of which plane i of thread t is planes[i * threads + t]. Of each thread `found` becomes the
/// lowest lane that differs, in the lowest 5 bits, and above them the clock; ~0 where none does.
/// Its first line is a comment with the layout. COSIM_LOCAL says how many planes are in local
/// memory, and LOP3 that the device has this instruction.
std::string to_opencl(const Code& code);

/// The kernels on the device, compiled when they are first asked for and kept.
class Gpu {
 public:
  /// Threads that share local memory. Few, because a group has at most 48 kB of it, 384 planes a
  /// thread, and a multiprocessor runs as many groups as fit.
  static constexpr std::size_t group = 32;

  /// From `folder`, where that is kept that was made of the same `key`; else of what source()
  /// gives. InputError where there is no device, or it compiles no kernel.
  Gpu(const std::filesystem::path& folder, const std::string& key,
      const std::function<std::string()>& source);

  Device device;
  Layout layout;
  std::size_t threads = 0;
  int lanes = 0;  ///< 32 a thread
  /// What runs, in a line: the device, cells, and where the planes are.
  std::string about;
  /// How fast it was so far, in a line; a share of its limit where that is known.
  std::string speed() const;

 private:
  friend class GpuPlayer;
  std::uint64_t cells_ = 0;  // a clock
  Device::Object begin_, run_, planes_, found_, left_out_;
  std::uint64_t clocks_ = 0;  // of all lanes
  double seconds_ = 0;
  std::recursive_mutex busy_;
};

/// As Player. Only one of all threads' is at work at a time.
class GpuPlayer {
 public:
  GpuPlayer(Gpu& gpu, const AnyBench& bench);

  void begin(std::uint64_t seed, std::uint64_t first, std::uint64_t count);
  void work_below(std::size_t lane) { at_work_ = std::min<std::uint64_t>(at_work_, lane); }
  /// Goes on up to clock number `to`. The lowest lane that differs on any of them, and its first
  /// clock of those.
  std::optional<Player::Differs> run(std::uint64_t to);
  const std::vector<std::uint64_t>& left_out() const { return left_out_; }

 private:
  std::size_t threads() const;  // at work, in whole groups

  Gpu& gpu_;
  std::unique_lock<std::recursive_mutex> alone_;
  std::uint64_t at_work_ = 0, clock_ = 0;
  std::vector<std::uint64_t> left_out_;
};

}  // namespace cosim::lanes
