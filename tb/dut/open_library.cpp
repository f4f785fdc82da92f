#include "tb/dut/open_dut.h"

#include <dlfcn.h>
#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <mutex>
#include <string>

#include "model/core/input_error.h"
#include "tb/util/build_targets.h"

namespace cosim {
namespace {

// It takes Verilator's library from the program: both must see the same context of a thread.
void* loaded(const OpenLibrary& library) { return dlopen(library.file, RTLD_NOW | RTLD_LOCAL); }

}  // namespace

MakeOpen open_maker_in(const OpenLibrary& library, const char* id) {
  static std::mutex guard;
  const std::lock_guard lock(guard);
  void* all = loaded(library);
  if (all == nullptr) {
    if (isatty(STDERR_FILENO) != 0)
      fmt::print(stderr, "Building the RTL with every net open, once\n");
    build_targets(library.cmake, library.build_folder, {library.target});
    all = loaded(library);
  }
  if (all == nullptr && !std::filesystem::exists(library.file)) {
    throw InputError(fmt::format(
        "{}: the RTL has changed since this program was built: build it again", library.target));
  }
  void* make = all == nullptr ? nullptr : dlsym(all, (std::string("open_") + id).c_str());
  if (make == nullptr)
    throw InputError(fmt::format("{}: cannot be loaded: {}", library.file, dlerror()));
  return reinterpret_cast<MakeOpen>(make);
}

}  // namespace cosim
