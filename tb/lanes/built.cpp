#include "tb/lanes/built.h"

#include <dlfcn.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "model/core/input_error.h"
#include "tb/util/file_lock.h"
#include "tb/util/hash.h"
#include "tb/util/leftover.h"
#include "tb/util/output_file.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"

namespace cosim::lanes {
namespace {

namespace fs = std::filesystem;

// The first line that a program says of itself.
std::string version(const std::string& program, const char* option) {
  const Ended ended = run_program({program, option});
  if (ended.status == 127) {
    throw InputError(
        fmt::format("lanes: need {}, which is not installed; --lanes 0 runs without it", program));
  }
  return ended.text.substr(0, ended.text.find('\n'));
}

// Vectors of this width, or of less where this processor has none; other architectures have no such
// options.
std::string vectors_of([[maybe_unused]] int lanes) {
#ifdef __x86_64__
  if (std::min(lanes, widest()) == 512) return "-mavx512f";
  if (std::min(lanes, widest()) == 256) return "-mavx2";
#endif
  return "-O2";
}

void compile(const fs::path& library, int lanes, const std::string& source) {
  const Scratch scratch;
  const fs::path file = scratch.path() / "lanes.cpp", made = scratch.path() / "lanes.so";
  std::ofstream(file) << source;
  // The statements stand in the order in which they need least memory: it is left to them.
  const Ended ended =
      run_program({COSIM_COMPILER, "-std=c++17", "-O2", "-fno-tree-reassoc", vectors_of(lanes),
                   "-w", "-fPIC", "-shared", "-o", made.string(), file.string()});
  if (ended.status != 0) {
    throw InputError(fmt::format("lanes: {} fails: {}", COSIM_COMPILER,
                                 ended.text.substr(0, ended.text.find('\n'))));
  }
  // Beside it first: an interrupt leaves no half library.
  const Leftover half(beside(library.string()));
  std::error_code error;
  fs::copy_file(made, half.path(), error);
  if (!error) fs::rename(half.path(), library, error);
  if (error) throw InputError(fmt::format("{}: {}", library.string(), error.message()));
}

}  // namespace

int widest() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f")) return 512;
  if (__builtin_cpu_supports("avx2")) return 256;
#endif
  return 64;
}

Built::Built(fs::path from)
    : library(std::move(from)), handle_(dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (handle_ == nullptr) throw InputError(fmt::format("lanes: {}", dlerror()));
  reset = reinterpret_cast<Act>(dlsym(handle_, "cosim_lanes_reset"));
  take_over = reinterpret_cast<Act>(dlsym(handle_, "cosim_lanes_take_over"));
  choose = reinterpret_cast<Choose>(dlsym(handle_, "cosim_lanes_choose"));
  clear = reinterpret_cast<Clear>(dlsym(handle_, "cosim_lanes_clear"));
  run = reinterpret_cast<Run>(dlsym(handle_, "cosim_lanes_run"));
  const void* own = dlsym(handle_, "cosim_lanes");
  const void* text = dlsym(handle_, "cosim_lanes_layout");
  if (reset == nullptr || take_over == nullptr || choose == nullptr || clear == nullptr ||
      run == nullptr || own == nullptr || text == nullptr) {
    dlclose(handle_);
    throw InputError(library.string() + ": no lanes in it");
  }
  lanes = *static_cast<const int*>(own);
  layout = parse_layout(static_cast<const char*>(text));
}
Built::~Built() { dlclose(handle_); }

std::string tools() {
  return fmt::format("{}\n{}", version(COSIM_COMPILER, "--version"), version("yosys", "-V"));
}

std::unique_ptr<Built> built(const fs::path& folder, const std::string& key, int lanes,
                             const std::function<std::string()>& source) {
  const fs::path library = folder / (hash_of(key + vectors_of(lanes)) + ".so");
  if (!fs::exists(library)) {
    const std::string text = source();  // what is refused leaves nothing
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw InputError(fmt::format("{}: {}", folder.string(), error.message()));
    // Who asks for it meanwhile waits, and compiles nothing.
    const FileLock lock(library.string() + ".lock", FileLock::Held::kWait);
    if (!fs::exists(library)) compile(library, lanes, text);
  }
  return std::make_unique<Built>(library);
}

}  // namespace cosim::lanes
