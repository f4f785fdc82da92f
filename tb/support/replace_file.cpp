#include "tb/support/replace_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "model/core/input_error.h"
#include "tb/support/leftover.h"

namespace cosim {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

bool write_all(std::FILE* file, const std::string& text) {
  return std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0 &&
         fsync(fileno(file)) == 0;
}

}  // namespace

std::string replaceable(const std::string& path) {
  namespace fs = std::filesystem;
  if (path.starts_with("/dev/") || path.starts_with("/proc/")) return {};
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(path, error), error);
  const fs::file_type type = fs::status(place, error).type();
  if (path.empty() || (type != fs::file_type::regular && type != fs::file_type::not_found))
    return {};
  if (beside(place.filename().string()).size() > NAME_MAX) return {};
  return access(place.parent_path().c_str(), W_OK) == 0 ? place.string() : "";
}

std::string beside(const std::string& path) {
  std::uint64_t number = 0;
  if (getrandom(&number, sizeof number, 0) != sizeof number) {
    throw InputError(fmt::format("{}: no random name: {}", path, std::strerror(errno)));
  }
  return fmt::format("{}.{:016x}.cosim-new", path, number);
}

int open_beside(const std::string& path, const std::string& name) {
  const int file = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  struct stat old {};
  // Where the rights cannot be given, the file is still the one that was asked for.
  if (file >= 0 && stat(path.c_str(), &old) == 0 && fchmod(file, old.st_mode & 07777) != 0) {
    errno = 0;
  }
  return file;
}

void replace_file(const std::string& path, const std::string& text) {
  Leftover half(beside(path));
  const int number = open_beside(path, half.path());
  const File file(number < 0 ? nullptr : fdopen(number, "w"));
  if (!file || !write_all(file.get(), text) ||
      std::rename(half.path().c_str(), path.c_str()) != 0) {
    throw InputError(fmt::format("{}: cannot write: {}", path, std::strerror(errno)));
  }
  half.keep();
}

}  // namespace cosim
