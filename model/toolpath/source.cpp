#include "model/toolpath/source.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "model/core/input_error.h"

namespace cosim::toolpath {

namespace {

std::string printable(std::string_view name) {
  std::string text(name);
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = '?';
  }
  return text;
}

[[noreturn]] void fail_file(const std::string& path, const std::string& what) {
  throw InputError(printable(path) + ": " + what);
}

std::string reason(int error) { return std::generic_category().message(error); }

}  // namespace

void fail(std::string_view name, Place place, std::string_view what) {
  throw InputError(printable(name) + ":" + std::to_string(place.line) + ":" +
                   std::to_string(place.column) + ": " + std::string(what));
}

std::string read_text(const std::string& path) {
  // The kind is asked before opening: opening a pipe that nobody writes to would never return.
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    fail_file(path, "no such file");
  }
  if (error) fail_file(path, "cannot be read: " + reason(error.value()));
  if (std::filesystem::is_directory(status)) fail_file(path, "is a directory, not a file");
  if (!std::filesystem::is_regular_file(status)) fail_file(path, "is not a regular file");

  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail_file(path, "cannot be read: " + reason(errno));
  std::string text;
  // A guess, for a file may grow: it spares the copies of a text that does.
  const auto size = std::filesystem::file_size(path, error);
  if (!error) text.reserve(std::min<std::uintmax_t>(size, max_text_bytes));
  std::string part(std::size_t{1} << 16, '\0');
  while (file) {
    file.read(part.data(), static_cast<std::streamsize>(part.size()));
    text.append(part, 0, static_cast<std::size_t>(file.gcount()));
    if (text.size() > max_text_bytes) {
      fail_file(path, "is larger than " + std::to_string(max_text_bytes >> 20) + " MiB");
    }
  }
  if (file.bad()) fail_file(path, "cannot be read: " + reason(errno));
  return text;
}

}  // namespace cosim::toolpath
