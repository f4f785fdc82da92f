#include "tb/checkpoint.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "model/core/input_error.h"
#include "tb/replace_file.h"

namespace cosim {
namespace {

// FNV-1a of the program's file: another build may have other cases, or other RTL.
std::uint64_t program() {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text_of_file("/proc/self/exe")) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  }
  return hash;
}

// More than any work keeps: what is no checkpoint may be of any size.
constexpr std::uintmax_t most_bytes = std::uintmax_t{4} << 20;

// The work of a checkpoint, short enough for an error.
std::string shown(const Checkpoint::Json& work) {
  constexpr std::size_t longest = 400;
  const std::string text = work.dump(-1, ' ', true);  // ASCII: can be cut anywhere
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

}  // namespace

Checkpoint::Checkpoint(std::string path, std::string work) : path_(std::move(path)) {
  if (path_.empty()) return;
  work_ = fmt::format("{}, program {:016x}", work, program());
  std::error_code none;
  if (std::filesystem::exists(path_, none) && !std::filesystem::is_regular_file(path_, none)) {
    throw InputError(path_ + ": no checkpoint: not a regular file");
  }
}

Checkpoint::Json Checkpoint::state() const {
  if (path_.empty() || !std::filesystem::exists(path_)) return {};
  if (std::filesystem::file_size(path_) > most_bytes) {
    throw InputError(path_ + ": no checkpoint: larger than 4 MiB");
  }
  const Json file = Json::parse(text_of_file(path_), nullptr, false);
  if (!file.is_object() || !file.contains("work") || !file.contains("state")) {
    throw InputError(path_ + ": no checkpoint");
  }
  if (file["work"] != work_) {
    throw InputError(fmt::format("{}: a checkpoint of other work or of another build: {}", path_,
                                 shown(file["work"])));
  }
  return file["state"];
}

void Checkpoint::save(const Json& state) {
  if (path_.empty()) return;
  replace_file(path_, Json{{"work", work_}, {"state", state}}.dump() + '\n');
  saved_ = std::chrono::steady_clock::now();
}

bool Checkpoint::due() const {
  return !path_.empty() &&
         std::chrono::steady_clock::now() - saved_ >= std::chrono::milliseconds(100);
}

void Checkpoint::done() {
  if (!path_.empty()) std::filesystem::remove(path_);
}

}  // namespace cosim
