// An output file that is whole or an error: every write is checked.
#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <iterator>
#include <string>
#include <utility>

namespace cosim {

class OutputFile {
 public:
  /// Opens the file for writing. An empty path gives a file that takes text and writes nothing.
  /// InputError where the file cannot be written, here and below.
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Writes text as it is.
  void text(const std::string& text) {
    if (file_ == nullptr) return;
    buffer_.append(text);
    flush();
  }
  /// Writes a line.
  template <class... Values>
  void line(fmt::format_string<Values...> format, Values&&... values) {
    if (file_ == nullptr) return;
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Values>(values)...);
    buffer_.push_back('\n');
    if (buffer_.size() > std::size_t{1} << 16) flush();
  }

  /// To be called when all is in.
  void close();

 private:
  void flush();
  [[noreturn]] void fail() const;
  std::string path_;
  std::FILE* file_ = nullptr;
  std::string buffer_;
};

}  // namespace cosim
