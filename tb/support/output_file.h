// An output file that is whole or an error: every write is checked, and until it is whole it has
// another name where it can, and what stood there before stays.
#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "tb/support/leftover.h"

namespace cosim {

class OutputFile {
 public:
  /// Opens the file for writing; of one that can be replaced at once, as replace_file.h has it, the
  /// one that takes its place. An empty path gives a file that takes text and writes nothing.
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

  /// To be called when all is in: then it stands there.
  void close();

 private:
  void flush();
  [[noreturn]] void fail() const;
  std::string path_, place_;
  std::optional<Leftover> half_;
  std::FILE* file_ = nullptr;
  std::string buffer_;
};

}  // namespace cosim
