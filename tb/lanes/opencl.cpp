// The functions and numbers are those of OpenCL 1.2, whose binary interface is fixed.
#include <dlfcn.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "model/core/input_error.h"
#include "tb/lanes/gpu.h"

namespace cosim::lanes {
namespace {

InputError missing(const std::string& what) {
  return InputError(fmt::format(
      "--lanes gpu: {}: install the driver of the card, or pocl-opencl-icd to run it on the CPU "
      "(scripts/setup gpu); --lanes auto runs without it",
      what));
}

// What the function of this name returns: an error, or an object.
template <class Returned = int, class... Arguments>
Returned result_of(const char* name, Arguments... arguments) {
  static void* const library = dlopen("libOpenCL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw missing("OpenCL is not installed");
  void* const found = dlsym(library, name);
  if (found == nullptr) throw missing(fmt::format("libOpenCL.so.1 has no {}", name));
  return reinterpret_cast<Returned (*)(Arguments...)>(found)(arguments...);
}
void check(const char* name, int error) {
  if (error != 0) throw InputError(fmt::format("--lanes gpu: {} fails: error {}", name, error));
}
template <class... Arguments>
void call(const char* name, Arguments... arguments) {
  check(name, result_of(name, arguments...));
}
// The error is behind the arguments.
template <class... Arguments>
Device::Object made(const char* release, const char* name, Arguments... arguments) {
  int error = 0;
  void* object = result_of<void*>(name, arguments..., &error);
  check(name, error);
  return {object, [release](void* o) { result_of(release, o); }};
}
const void* const no_pointer = nullptr;

}  // namespace

Device::Device() {
  std::array<void*, 64> platforms{};
  // With no platform the loader reports an error, too.
  result_of("clGetPlatformIDs", 64U, platforms.data(), no_pointer);
  constexpr std::uint64_t gpu = 4, any = 0xffffffff;
  for (const std::uint64_t type : {gpu, any}) {
    for (void* const platform : platforms) {
      if (platform == nullptr || id_ != nullptr) continue;
      if (result_of("clGetDeviceIDs", platform, type, 1U, &id_, no_pointer) != 0) id_ = nullptr;
      threads = type == gpu ? 1536 : 64;  // of a unit
    }
  }
  if (id_ == nullptr) throw missing("OpenCL has no device");
  const auto info = [&](std::uint32_t what, auto value) {
    call("clGetDeviceInfo", id_, what, sizeof value, &value, no_pointer);
    return value;
  };
  const std::array<char, 1024> text{};
  name = info(0x102b, text).data();
  is_nvidia = std::string(info(0x102c, text).data()).find("NVIDIA") != std::string::npos;
  local_bytes = info(0x1023, 0UL);
  version = fmt::format("{}\n{}\n{}", name, info(0x102d, text).data(), local_bytes);
  // A unit is a multiprocessor, which runs 64 of these instructions at once, or a core of a CPU.
  const std::uint32_t units = info(0x1002, 0U), megahertz = info(0x100c, 0U);
  lop3_limit = 32 * 64e6 * units * megahertz;
  threads *= units;
  context_ =
      made("clReleaseContext", "clCreateContext", no_pointer, 1U, &id_, no_pointer, no_pointer);
  queue_ = made("clReleaseCommandQueue", "clCreateCommandQueue", context_.get(), id_, 0UL);
}

Device::Object Device::program(const std::string& code, bool is_binary) const {
  const char* bytes = code.data();
  const std::size_t size = code.size();
  const Object all = is_binary ? made("clReleaseProgram", "clCreateProgramWithBinary",
                                      context_.get(), 1U, &id_, &size, &bytes, no_pointer)
                               : made("clReleaseProgram", "clCreateProgramWithSource",
                                      context_.get(), 1U, &bytes, &size);
  if (const int error =
          result_of("clBuildProgram", all.get(), 1U, &id_, no_pointer, no_pointer, no_pointer)) {
    std::string log(std::size_t{1} << 16, '\0');
    call("clGetProgramBuildInfo", all.get(), id_, 0x1183U, log.size(), log.data(), no_pointer);
    log.resize(std::min(log.find('\0'), log.find('\n')));
    throw InputError(
        fmt::format("--lanes gpu: {} compiles no kernel: error {}: {}", name, error, log));
  }
  return all;
}
std::string Device::binary_of(const Object& program) {
  std::size_t size = 0;
  call("clGetProgramInfo", program.get(), 0x1165U, sizeof size, &size, no_pointer);
  std::string binary(size, '\0');
  char* bytes = binary.data();
  call("clGetProgramInfo", program.get(), 0x1166U, sizeof bytes, &bytes, no_pointer);
  return binary;
}
Device::Object Device::kernel(const Object& program, const char* name) {
  return made("clReleaseKernel", "clCreateKernel", program.get(), name);
}
Device::Object Device::buffer(std::size_t bytes) const {
  return made("clReleaseMemObject", "clCreateBuffer", context_.get(), 1UL, bytes, no_pointer);
}
void Device::read(const Object& buffer, std::vector<std::uint32_t>& to, std::size_t first) const {
  call("clEnqueueReadBuffer", queue_.get(), buffer.get(), 1U, 4 * first, 4 * to.size(), to.data(),
       0U, no_pointer, no_pointer);
}
void Device::run(const Object& kernel, std::size_t count,
                 const std::vector<Argument>& arguments) const {
  std::uint32_t i = 0;
  const auto set = [&](const auto& value) {
    call("clSetKernelArg", kernel.get(), i++, sizeof value, &value);
  };
  for (const Argument& argument : arguments) std::visit(set, argument);
  call("clEnqueueNDRangeKernel", queue_.get(), kernel.get(), 1U, no_pointer, &count, &group, 0U,
       no_pointer, no_pointer);
  call("clFinish", queue_.get());
}

}  // namespace cosim::lanes
