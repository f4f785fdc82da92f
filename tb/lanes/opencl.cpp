// The functions and numbers are those of OpenCL 1.2, whose binary interface is fixed.
#include "tb/lanes/gpu.h"

#include <dlfcn.h>
#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"

namespace cosim::lanes {
namespace {

constexpr const char* to_install =
    "--lanes gpu: {}: install the driver of the card, or pocl-opencl-icd to run it on the CPU "
    "(scripts/setup gpu); --lanes auto runs without it";

void* symbol(const char* name) {
  static void* const library = dlopen("libOpenCL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    throw InputError(fmt::format(fmt::runtime(to_install), "OpenCL is not installed"));
  }
  if (void* found = dlsym(library, name)) return found;
  throw InputError(fmt::format("--lanes gpu: libOpenCL.so.1 has no {}", name));
}
void check(const char* name, int error) {
  if (error != 0) throw InputError(fmt::format("--lanes gpu: {} fails: error {}", name, error));
}
// A function that returns an error.
template <class... Arguments>
void call(const char* name, Arguments... arguments) {
  check(name, reinterpret_cast<int (*)(Arguments...)>(symbol(name))(arguments...));
}
// One that returns an object, and the error behind its arguments.
template <class... Arguments>
void* made(const char* name, Arguments... arguments) {
  int error = 0;
  void* object =
      reinterpret_cast<void* (*)(Arguments..., int*)>(symbol(name))(arguments..., &error);
  check(name, error);
  return object;
}
Device::Object owned(void* object, const char* release) {
  return {object, [release](void* o) { reinterpret_cast<int (*)(void*)>(symbol(release))(o); }};
}

using Number32 = std::uint32_t;
using Flags = std::uint64_t;
const void* const no_pointer = nullptr;

// Of each platform the first such device.
void* device_of(const std::vector<void*>& platforms, Flags type) {
  for (void* platform : platforms) {
    void* device = nullptr;
    Number32 count = 0;
    const auto get = reinterpret_cast<int (*)(void*, Flags, Number32, void**, Number32*)>(
        symbol("clGetDeviceIDs"));
    if (get(platform, type, 1, &device, &count) == 0 && count != 0) return device;
  }
  return nullptr;
}

}  // namespace

Device::Device() {
  Number32 count = 0;
  // With no platform the loader reports an error, too.
  reinterpret_cast<int (*)(Number32, void**, Number32*)>(symbol("clGetPlatformIDs"))(0, nullptr,
                                                                                     &count);
  std::vector<void*> platforms(count);
  if (count != 0)
    call("clGetPlatformIDs", count, platforms.data(), static_cast<Number32*>(nullptr));
  constexpr Flags gpu = 4, any = 0xffffffff;
  id_ = device_of(platforms, gpu);
  is_gpu = id_ != nullptr;
  if (!is_gpu) id_ = device_of(platforms, any);
  if (id_ == nullptr) {
    throw InputError(fmt::format(fmt::runtime(to_install), "OpenCL has no device"));
  }
  name = text_of(0x102b);
  version = text_of(0x102d);
  is_nvidia = text_of(0x102c).find("NVIDIA") != std::string::npos;
  units = number_of<Number32>(0x1002);
  megahertz = number_of<Number32>(0x100c);
  local_bytes = number_of<Flags>(0x1023);
  context_ = owned(made("clCreateContext", no_pointer, Number32{1}, static_cast<void* const*>(&id_),
                        no_pointer, no_pointer),
                   "clReleaseContext");
  queue_ =
      owned(made("clCreateCommandQueue", context_.get(), id_, Flags{0}), "clReleaseCommandQueue");
}

std::string Device::text_of(Number32 what) const {
  std::size_t size = 0;
  call("clGetDeviceInfo", id_, what, std::size_t{0}, no_pointer, &size);
  std::string text(size, '\0');
  call("clGetDeviceInfo", id_, what, size, text.data(), static_cast<std::size_t*>(nullptr));
  return text.c_str();
}
template <class Number>
Number Device::number_of(Number32 what) const {
  Number number{};
  call("clGetDeviceInfo", id_, what, sizeof number, &number, static_cast<std::size_t*>(nullptr));
  return number;
}

Device::Object Device::built(void* program, const std::string& options) const {
  Object owner = owned(program, "clReleaseProgram");
  const auto build = reinterpret_cast<int (*)(void*, Number32, void* const*, const char*,
                                              const void*, const void*)>(symbol("clBuildProgram"));
  if (const int error = build(program, 1, &id_, options.c_str(), nullptr, nullptr)) {
    std::string log(std::size_t{1} << 16, '\0');
    call("clGetProgramBuildInfo", program, id_, Number32{0x1183}, log.size(), log.data(),
         static_cast<std::size_t*>(nullptr));
    log.resize(std::min(log.find('\0'), log.find('\n')));
    throw InputError(
        fmt::format("--lanes gpu: {} compiles no kernel: error {}: {}", name, error, log));
  }
  return owner;
}
Device::Object Device::program(const std::string& source, const std::string& options) const {
  const char* text = source.c_str();
  return built(made("clCreateProgramWithSource", context_.get(), Number32{1}, &text, no_pointer),
               options);
}
Device::Object Device::program(const std::string& binary) const {
  const std::size_t size = binary.size();
  const char* bytes = binary.data();
  return built(made("clCreateProgramWithBinary", context_.get(), Number32{1},
                    static_cast<void* const*>(&id_), &size, &bytes, no_pointer),
               "");
}
std::string Device::binary_of(const Object& program) {
  std::size_t size = 0;
  std::size_t* const no_size = nullptr;
  call("clGetProgramInfo", program.get(), Number32{0x1165}, sizeof size, &size, no_size);
  std::string binary(size, '\0');
  char* bytes = binary.data();
  call("clGetProgramInfo", program.get(), Number32{0x1166}, sizeof bytes, &bytes, no_size);
  return binary;
}
Device::Object Device::kernel(const Object& program, const char* name) {
  return owned(made("clCreateKernel", program.get(), name), "clReleaseKernel");
}

Device::Object Device::buffer(std::size_t bytes) const {
  return owned(made("clCreateBuffer", context_.get(), Flags{1}, bytes, no_pointer),
               "clReleaseMemObject");
}
void Device::read(const Object& buffer, std::vector<std::uint32_t>& to, std::size_t first) const {
  call("clEnqueueReadBuffer", queue_.get(), buffer.get(), Number32{1}, 4 * first, 4 * to.size(),
       to.data(), Number32{0}, no_pointer, no_pointer);
}

void Device::set(const Object& kernel, Number32 i, const void* value, std::size_t bytes) {
  call("clSetKernelArg", kernel.get(), i, bytes, value);
}
void Device::set(const Object& kernel, Number32 i, const Object& buffer) {
  void* const object = buffer.get();
  set(kernel, i, &object, sizeof object);
}
void Device::launch(const Object& kernel, std::size_t threads, std::size_t group) const {
  call("clEnqueueNDRangeKernel", queue_.get(), kernel.get(), Number32{1}, no_pointer, &threads,
       &group, Number32{0}, no_pointer, no_pointer);
  call("clFinish", queue_.get());
}

}  // namespace cosim::lanes
