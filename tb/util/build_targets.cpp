#include "tb/util/build_targets.h"

#include <fmt/core.h>

#include <filesystem>

#include "model/core/input_error.h"
#include "tb/util/file_lock.h"
#include "tb/util/process.h"

namespace cosim {

namespace fs = std::filesystem;

void build_targets(const std::string& cmake, const std::string& folder,
                   const std::vector<std::string>& targets) {
  if (!fs::exists(fs::path(folder) / "CMakeCache.txt")) {
    throw InputError(
        fmt::format("{}: the build folder is gone; configure and build again", folder));
  }
  // ninja does not look whether another one is at work.
  const FileLock lock(fs::path(folder) / ".on-demand", FileLock::Held::kWait);
  std::vector<std::string> words{cmake, "--build", folder, "--target"};
  words.insert(words.end(), targets.begin(), targets.end());
  const Ended ended = run_program(words);
  if (ended.status == 0) return;
  // What the compiler says is worth many lines; what keeps it from running is one.
  if (ended.text.find("FAILED: ") != std::string::npos) {
    fmt::print(stderr, "{}", ended.text);
    throw InputError(fmt::format("{}: cannot be built", targets.front()));
  }
  const std::string text = ended.text.substr(0, ended.text.find_last_not_of('\n') + 1);
  throw InputError(fmt::format("{}: cannot be built: {}", targets.front(),
                               text.substr(text.find_last_of('\n') + 1)));
}

}  // namespace cosim
