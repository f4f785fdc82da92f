// Hostile cases on a device of OpenCL: a thread has 32 lanes, and runs all clocks of its cases.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <variant>
#include <vector>

#include "tb/lanes/code.h"
#include "tb/lanes/player.h"

namespace cosim::lanes {

/// The first GPU or, where there is none, the first device. Neither the headers nor the library of
/// OpenCL is needed to build: the library is loaded when a device is asked for. Everything throws
/// InputError, one line, where OpenCL reports an error.
class Device {
 public:
  /// A kernel, a program or a buffer, released with the last copy.
  using Object = std::shared_ptr<void>;
  /// Of a kernel: a number, or a buffer.
  using Argument = std::variant<std::uint32_t, std::uint64_t, void*>;

  /// InputError that says what to install where there is no OpenCL or no device.
  Device();

  std::string name, version;      ///< `version`: what its binaries depend on
  bool is_nvidia = false;         ///< its cells are single instructions, lop3
  double lop3_limit = 0;          ///< so many of them a second, each on 32 lanes
  std::uint32_t threads = 0;      ///< as many as keep it busy
  std::uint64_t local_bytes = 0;  ///< of fast memory that the threads of a group share

  /// Compiles a source, or takes a binary of this device and driver.
  Object program(const std::string& code, bool is_binary) const;
  static std::string binary_of(const Object& program);
  static Object kernel(const Object& program, const char* name);
  Object buffer(std::size_t bytes) const;
  void read(const Object& buffer, std::vector<std::uint32_t>& to, std::size_t first = 0) const;
  /// Threads that share local memory. Few, because a group has at most 48 kB of it, 384 planes a
  /// thread, and a multiprocessor runs as many groups as fit.
  static constexpr std::size_t group = 32;
  /// Runs a kernel with `count` threads, whole groups, to its end.
  void run(const Object& kernel, std::size_t count, const std::vector<Argument>& arguments) const;

 private:
  void* id_ = nullptr;
  Object context_, queue_;
};

/// The kernels of a design, as a source of OpenCL C for a device:
///
///   begin(planes, threads, seed, first)            the cases from number `first` on, after reset
///   run(planes, threads, from, to, count, found, left_out)
///                                                  clocks from .. to - 1 of `count` lanes
///
/// of which plane i of thread t is planes[i * threads + t]. Of each thread `found` becomes the
/// lowest lane that differs, in the lowest 5 bits, and above them the clock; ~0 where none does.
/// Its first line is a comment: the cells of a clock, the planes that it touches, how many of them
/// are in local memory, and the layout.
std::string to_opencl(const Code& code, const Device& device);

/// The kernels on the device, compiled when they are first asked for and kept.
class Gpu {
 public:
  /// From `folder`, where that is kept that was made of the same `key` for this device; else of
  /// what code() gives. InputError where there is no device, or it compiles no kernel. Prints a
  /// line: the device, cells, and where the planes are.
  Gpu(const std::filesystem::path& folder, const std::string& key,
      const std::function<Code()>& code);
  /// Prints a line: how fast it was, and the share of the device's limit where that is known.
  ~Gpu();

  std::uint64_t lanes = 0;  ///< 32 a thread
  /// Plays cases from number `first` of a seed on, part by part. Only one of all threads' calls is
  /// at work at a time. InputError where the reset does not reach every register.
  Outcome play(std::uint64_t seed, std::uint64_t first, const std::vector<Part>& parts);

 private:
  Device device_;
  Layout layout_;
  std::uint64_t cells_ = 0;  // a clock
  Device::Object begin_, run_, planes_, found_, left_out_;
  std::uint64_t clocks_ = 0;  // of all lanes
  double seconds_ = 0;
  std::mutex busy_;
};

}  // namespace cosim::lanes
