#include "tb/util/hash.h"

#include <fmt/core.h>

#include <fstream>
#include <memory>

#include "model/core/input_error.h"

#define XXH_INLINE_ALL
#define XXH_NO_INLINE_HINTS 1  // the hints cost seconds to compile
#include <xxhash.h>

namespace cosim {
namespace {

std::string digits(const XXH128_hash_t& hash) {
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

std::string hash_of(std::string_view text) {
  return digits(XXH3_128bits(text.data(), text.size()));
}

std::string hash_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(),
                                                                       XXH3_freeState);
  XXH3_128bits_reset(state.get());
  std::string piece(1 << 20, '\0');
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    XXH3_128bits_update(state.get(), piece.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (!file.eof()) throw InputError(path + ": cannot be read");
  return digits(XXH3_128bits_digest(state.get()));
}

const std::string& program_hash() {
  static const std::string hash = hash_of_file("/proc/self/exe");
  return hash;
}

}  // namespace cosim
