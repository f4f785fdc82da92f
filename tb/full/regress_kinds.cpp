#include "tb/full/regress_kinds.h"

#include <fmt/core.h>

#include <system_error>

#include "model/core/input_error.h"

namespace cosim::cli {

regress::Kinds regress_kinds(const Registry& registry) {
  regress::Kinds kinds;
  kinds.push_back(sweep_kind(registry));
  kinds.push_back(prove_kind());
  kinds.push_back(mutate_kind(registry));
  kinds.push_back(fuzz_kind());
  kinds.push_back(run_kind());
  return kinds;
}

std::string kept_with(const std::string& key, const std::string& path,
                      const std::filesystem::path& plan, const std::filesystem::path& run) {
  namespace fs = std::filesystem;
  const fs::path from = plan / path;
  std::error_code error;
  if (!fs::exists(from, error)) throw InputError(fmt::format("{}: no such file: {}", key, path));
  // A folder of its own for each, so that equal names stay apart and the last name stays.
  std::size_t number = 0;
  while (fs::exists(run / "files" / std::to_string(number), error)) ++number;
  const fs::path place = fs::path("files") / std::to_string(number);
  const fs::path name = fs::canonical(from, error).filename();
  fs::create_directories(run / place, error);
  if (!error) fs::copy(from, run / place / name, fs::copy_options::recursive, error);
  if (error) {
    throw InputError(
        fmt::format("{}: cannot write: {}", (run / place / name).string(), error.message()));
  }
  return (place / name).string();
}

}  // namespace cosim::cli
