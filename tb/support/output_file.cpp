#include "tb/support/output_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "model/core/input_error.h"
#include "tb/support/replace_file.h"

namespace cosim {

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
