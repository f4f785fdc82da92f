#include "tb/sweep/checkpoint.h"

#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "model/core/input_error.h"
#include "tb/support/finite.h"
#include "tb/support/hash.h"
#include "tb/support/json.h"
#include "tb/support/read_file.h"
#include "tb/support/replace_file.h"

namespace cosim {
namespace {

// No checkpoint is larger; another file may be of any size.
constexpr std::uintmax_t most_bytes = std::uintmax_t{4} << 20;

// The work of a checkpoint, short enough for an error.
std::string shown(const Json& work) {
  constexpr std::size_t longest = 400;
  const std::string text = json_ascii(work);  // ASCII: can be cut anywhere
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

}  // namespace

// By words and in pieces, because with debug information the file has hundreds of MB.
std::uint64_t program_hash() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  std::array<char, 1 << 16> piece;
  do {
    piece.fill(0);
    file.read(piece.data(), piece.size());
    for (std::size_t i = 0; i < piece.size(); i += sizeof hash) {
      std::uint64_t word = 0;
      std::memcpy(&word, piece.data() + i, sizeof word);
      hash = (hash ^ word) * 0x9e3779b97f4a7c15ULL;
      hash ^= hash >> 32;
    }
  } while (file);
  if (!file.eof()) throw InputError("cannot read /proc/self/exe");
  return hash;
}

Checkpoint::Checkpoint(std::string path, std::string work) : path_(std::move(path)) {
  if (path_.empty()) return;
  work_ = fmt::format("{}, program {:016x}", work, program_hash());
  std::error_code none;
  if (std::filesystem::exists(path_, none) && !std::filesystem::is_regular_file(path_, none)) {
    throw InputError(path_ + ": no checkpoint: not a regular file");
  }
}

Json Checkpoint::state() const {
  if (path_.empty() || !std::filesystem::exists(path_)) return {};
  if (std::filesystem::file_size(path_) > most_bytes) {
    throw InputError(path_ + ": no checkpoint: larger than 4 MiB");
  }
  const Json file = json_if(read_file(path_));
  if (!file.is_object() || !file.contains("work") || !file.contains("state")) {
    throw InputError(path_ + ": no checkpoint");
  }
  if (file["work"] != work_) {
    throw InputError(fmt::format("{}: a checkpoint of other work or of another build: {}", path_,
                                 shown(file["work"])));
  }
  if (!file.contains("hash") || file["hash"] != hash_of(json_text(file["state"]))) {
    throw InputError(path_ + ": no checkpoint: it was changed");
  }
  return file["state"];
}

void Checkpoint::save(const Json& state) {
  if (path_.empty()) return;
  check_finite(state);
  replace_file(path_, json_text(Json{
                          {"work", work_}, {"hash", hash_of(json_text(state))}, {"state", state}}) +
                          '\n');
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
