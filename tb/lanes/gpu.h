// Hostile cases on a device of OpenCL: a thread has 32 lanes, and runs all clocks of its cases.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "tb/lanes/code.h"
#include "tb/lanes/player.h"
#include "tb/sim/bench.h"

namespace cosim::lanes {

// A device of OpenCL. Neither its headers nor its library is needed to build: the library is loaded
// when a device is asked for.

/// The first GPU or, where there is none, the first device. Everything throws InputError, one line,
/// where OpenCL reports an error.
class Device {
 public:
  /// A kernel, a program or a buffer, released with the last copy.
  using Object = std::shared_ptr<void>;

  /// InputError that says what to install where there is no OpenCL or no device.
  Device();

  std::string name, version;  ///< of the device and of its driver
  bool is_nvidia = false;     ///< its cells are single instructions, lop3
  bool is_gpu = false;
  std::uint32_t units = 0;        ///< multiprocessors, or cores of a CPU
  std::uint32_t megahertz = 0;    ///< the highest clock frequency
  std::uint64_t local_bytes = 0;  ///< of fast memory that the threads of a group share

  /// Compiles a source, or takes `binary`, an earlier one of the same source, device and driver.
  Object program(const std::string& source, const std::string& options) const;
  Object program(const std::string& binary) const;
  static std::string binary_of(const Object& program);
  static Object kernel(const Object& program, const char* name);

  Object buffer(std::size_t bytes) const;
  void read(const Object& buffer, std::vector<std::uint32_t>& to, std::size_t first = 0) const;

  /// Runs a kernel with `threads` threads in groups of `group`, to its end.
  template <class... Arguments>
  void run(const Object& kernel, std::size_t threads, std::size_t group,
           const Arguments&... arguments) const {
    std::uint32_t i = 0;
    (set(kernel, i++, arguments), ...);
    launch(kernel, threads, group);
  }

 private:
  static void set(const Object& kernel, std::uint32_t i, const Object& buffer);
  template <class Number>
  static void set(const Object& kernel, std::uint32_t i, Number number) {
    set(kernel, i, &number, sizeof number);
  }
  static void set(const Object& kernel, std::uint32_t i, const void* value, std::size_t bytes);
  void launch(const Object& kernel, std::size_t threads, std::size_t group) const;
  Object built(void* program, const std::string& options) const;
  std::string text_of(std::uint32_t what) const;
  template <class Number>
  Number number_of(std::uint32_t what) const;

  void* id_ = nullptr;
  Object context_, queue_;
};

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
