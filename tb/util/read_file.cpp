#include "tb/util/read_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "model/core/input_error.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw InputError(one_line(path) + ": " + what);
}

[[noreturn]] void fail(const std::string& path, int error) {
  fail(path, "cannot be read: " + std::generic_category().message(error));
}

}  // namespace

std::string read_file(const std::string& path) {
  namespace fs = std::filesystem;
  // The kind is asked before opening: opening a pipe that nobody writes to would never return.
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) fail(path, "no such file");
  if (error) fail(path, error.value());
  if (fs::is_directory(status)) fail(path, "is a directory, not a file");
  if (!fs::is_regular_file(status)) fail(path, "is not a regular file");

  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, errno);
  std::string text;
  // A guess, for a file may grow: it spares the copies of a text that does.
  const auto size = fs::file_size(path, error);
  if (!error) text.reserve(std::min<std::uintmax_t>(size, max_file_bytes));
  std::string part(std::size_t{1} << 16, '\0');
  while (file) {
    file.read(part.data(), static_cast<std::streamsize>(part.size()));
    text.append(part, 0, static_cast<std::size_t>(file.gcount()));
    if (text.size() > max_file_bytes) {
      fail(path, fmt::format("is larger than {} MiB", max_file_bytes >> 20));
    }
  }
  if (file.bad()) fail(path, errno);
  return text;
}

}  // namespace cosim
