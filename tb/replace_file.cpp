#include "tb/replace_file.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "model/core/input_error.h"

namespace cosim {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw InputError(fmt::format("{}: cannot {}: {}", path, what, std::strerror(errno)));
}

bool write_all(std::FILE* file, const std::string& text) {
  return std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0 &&
         fsync(fileno(file)) == 0;
}

}  // namespace

void replace_file(const std::string& path, const std::string& text) {
  const std::string beside = path + ".cosim-new";
  const File file(std::fopen(beside.c_str(), "w"));
  if (!file) fail(path, "write");
  if (!write_all(file.get(), text) || std::rename(beside.c_str(), path.c_str()) != 0) {
    const int error = errno;
    std::remove(beside.c_str());
    errno = error;
    fail(path, "write");
  }
}

std::string text_of_file(const std::string& path) {
  const File file(std::fopen(path.c_str(), "r"));
  if (!file) fail(path, "read");
  std::string text;
  char part[1 << 12];
  while (const std::size_t n = std::fread(part, 1, sizeof part, file.get())) text.append(part, n);
  if (std::ferror(file.get()) != 0) fail(path, "read");
  return text;
}

}  // namespace cosim
