#include "tb/equiv/verilated.h"

#include <fmt/core.h>

#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

#include "model/core/input_error.h"
#include "tb/rtl/regex.h"
#include "tb/util/hash.h"
#include "tb/util/output_file.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"

namespace cosim::equiv {
namespace {

namespace fs = std::filesystem;

fs::path cache() {
  for (const auto& [variable, below] : {std::pair{"XDG_CACHE_HOME", ""}, {"HOME", ".cache"}}) {
    const char* const folder = std::getenv(variable);
    if (folder != nullptr && fs::path(folder).is_absolute()) return fs::path(folder) / below;
  }
  return {};
}

// What changes with another version of a file.
std::string version_of(const fs::path& file) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  const auto size = fs::file_size(real, error);
  const auto time = fs::last_write_time(real, error).time_since_epoch().count();
  return error ? "" : fmt::format("{} {} {}\n", real.string(), size, time);
}

// Does work that matters to nobody if it cannot be done.
template <class Work>
void attempt(const Work& work) {
  try {
    work();
  } catch (const InputError&) {
  } catch (const fs::filesystem_error&) {
  }
}

}  // namespace

VerilatedLibrary::VerilatedLibrary(fs::path built) : built_(std::move(built)) {
  attempt([&] {
    static const rtl::Regex root("VERILATOR_ROOT = ([^\n]*)"),
        setting("(VM_[A-Z_]+ = \\w+|\tverilated\\w*)");
    const std::string main = read_file((built_ / "Vcosim_replay.mk").string()),
                      classes = read_file((built_ / "Vcosim_replay_classes.mk").string());
    const rtl::Match place = root.find(main);
    const fs::path compiler = path_of("g++");
    if (!place || compiler.empty() || cache().empty()) return;
    const fs::path include = fs::path(place[1]) / "include";
    std::string key = main + version_of(include / "verilated.cpp") +
                      version_of(include / "verilated.mk") + version_of(compiler);
    for (const rtl::Match& one : setting.all(classes)) key += one[0] + '\n';
    kept_ = cache() / "cosim" / ("verilated-" + hash_of(key));
  });
}

void VerilatedLibrary::put() const {
  attempt([&] {
    if (kept_.empty() || !fs::is_directory(kept_)) return;
    for (const auto& one : fs::directory_iterator(kept_)) {
      if (one.path().extension() == ".o") fs::copy_file(one, built_ / one.path().filename());
    }
  });
}

void VerilatedLibrary::keep() const {
  attempt([&] {
    if (kept_.empty()) return;
    fs::create_directories(kept_);
    for (const auto& one : fs::directory_iterator(built_)) {
      const std::string name = one.path().filename().string();
      const bool is_part = name.starts_with("verilated") && name.ends_with(".o");
      if (!is_part || fs::exists(kept_ / name)) continue;
      write_file((kept_ / name).string(), read_file(one.path().string()));
    }
  });
}

}  // namespace cosim::equiv
