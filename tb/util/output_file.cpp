#include "tb/util/output_file.h"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "model/core/input_error.h"

namespace cosim {

namespace {

// The path of the file after all links, if it can be replaced at once. Empty for pipes, devices and
// files of /proc, and if no file can be made in its folder.
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

}  // namespace

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

OutputFile::OutputFile(const std::string& path) : path_(path) {
  if (path_.empty()) return;
  place_ = replaceable(path_);
  if (place_.empty()) {
    file_ = std::fopen(path_.c_str(), "w");
  } else {
    half_.emplace(beside(place_));
    const int number = open_beside(place_, half_->path());
    file_ = number < 0 ? nullptr : fdopen(number, "w");
  }
  if (file_ == nullptr) fail();
}

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
}

void OutputFile::flush() {
  if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size()) fail();
  buffer_.clear();
}

void OutputFile::close() {
  if (file_ == nullptr) return;
  flush();
  std::FILE* file = file_;
  file_ = nullptr;
  if (std::fclose(file) != 0) fail();
  if (!half_) return;
  if (std::rename(half_->path().c_str(), place_.c_str()) != 0) fail();
  half_->keep();
}

void OutputFile::fail() const {
  throw InputError(fmt::format("{}: cannot write: {}", path_, std::strerror(errno)));
}

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw InputError(fmt::format("{}: cannot be made: {}", path, error.message()));
}

void write_file(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.text(text);
  file.close();
}

}  // namespace cosim
