// A device of OpenCL. Neither its headers nor its library is needed to build: the library is loaded
// when a device is asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cosim::lanes {

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

}  // namespace cosim::lanes
