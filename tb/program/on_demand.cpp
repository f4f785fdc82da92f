#include "tb/program/on_demand.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "model/core/input_error.h"
#include "tb/support/file_lock.h"
#include "tb/support/process.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

}  // namespace

const OnDemand& on_demand(const std::vector<OnDemand>& all, const std::string& title) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const OnDemand& o) { return o.title == title; });
  if (found == all.end()) throw InputError(title + ": there is no such program for it");
  return *found;
}

void build(const Registry& registry, const OnDemand& program) {
  const std::string& folder = registry.build_folder();
  if (!fs::exists(fs::path(folder) / "CMakeCache.txt")) {
    throw InputError(fmt::format("{}: there is no build folder any more", folder));
  }
  // ninja does not look whether another one is at work.
  const FileLock lock(fs::path(folder) / ".on-demand", FileLock::Held::kWait);
  const Ended ended =
      cosim::run_program({registry.cmake(), "--build", folder, "--target", program.target});
  if (ended.status == 0) return;
  // What the compiler says is worth many lines; what keeps it from running is one.
  if (ended.text.find("FAILED: ") != std::string::npos) {
    fmt::print(stderr, "{}", ended.text);
    throw InputError(fmt::format("{}: cannot be built", program.target));
  }
  const std::string text = ended.text.substr(0, ended.text.find_last_not_of('\n') + 1);
  throw InputError(fmt::format("{}: cannot be built: {}", program.target,
                               text.substr(text.find_last_of('\n') + 1)));
}

std::string path_of(const OnDemand& program) {
  return (fs::path(program.folder) / program.target).string();
}

}  // namespace cosim::cli
