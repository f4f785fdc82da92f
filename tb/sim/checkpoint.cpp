// A new file is written beside the old one and takes its place in one step (atomic replace). It has
// a hash of itself and names its work and program: another one does not go on from it.
#include "tb/sim/checkpoint.h"

#include <fmt/core.h>

#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#include "model/core/input_error.h"
#include "tb/util/finite.h"
#include "tb/util/hash.h"
#include "tb/util/json.h"
#include "tb/util/output_file.h"
#include "tb/util/read_file.h"

namespace cosim {
namespace {

// No checkpoint is larger; another file may be of any size.
constexpr std::uintmax_t most_bytes = std::uintmax_t{4} << 20;

}  // namespace

Checkpoint::Checkpoint(std::string path, std::string work, std::chrono::milliseconds pace)
    : path_(std::move(path)), pace_(pace) {
  if (path_.empty()) return;
  work_ = fmt::format("{}, program {}", work, program_hash());
  std::error_code none;
  if (std::filesystem::exists(path_, none) && !std::filesystem::is_regular_file(path_, none)) {
    throw InputError(path_ + ": no checkpoint: not a regular file");
  }
}

std::optional<JsonAt> Checkpoint::state() const {
  if (path_.empty() || !std::filesystem::exists(path_)) return std::nullopt;
  if (std::filesystem::file_size(path_) > most_bytes) {
    throw InputError(path_ + ": no checkpoint: larger than 4 MiB");
  }
  const JsonAt file(path_ + ": no checkpoint", read_file(path_));
  const JsonAt work = file.at("work"), state = file.at("state");
  if (work.json() != work_) {
    throw InputError(fmt::format("{}: a checkpoint of other work or of another build: {}", path_,
                                 json_short(work.json(), 400)));
  }
  if (file.at("hash").text() != hash_of(json_text(state.json()))) {
    throw InputError(path_ + ": no checkpoint: it was changed");
  }
  return state;
}

void Checkpoint::save(const Json& state) {
  if (path_.empty()) return;
  check_finite(state);
  write_file(path_, json_text(Json{
                        {"work", work_}, {"hash", hash_of(json_text(state))}, {"state", state}}) +
                        '\n');
  saved_ = std::chrono::steady_clock::now();
}

bool Checkpoint::due() const {
  return !path_.empty() && std::chrono::steady_clock::now() - saved_ >= pace_;
}

void Checkpoint::done() {
  if (!path_.empty()) std::filesystem::remove(path_);
}

}  // namespace cosim
