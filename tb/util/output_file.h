// An output file that is complete, or an error. Every write is checked. If possible the file is
// written under another name, so that an older file stays until the new one is complete.
#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "tb/util/leftover.h"

namespace cosim {

/// A name under which the replacement of a file is written: FILE.NUMBER.cosim-new with another
/// random number each time, so that nothing has that name.
std::string beside(const std::string& path);

/// Makes the file of that name, with the rights of the file `path` that it replaces, and returns
/// its descriptor; -1 and errno on failure, also where something has that name.
int open_beside(const std::string& path, const std::string& name);

class OutputFile {
 public:
  /// Opens the file for writing, or the file that will replace it. With an empty path all text is
  /// dropped. InputError if the file cannot be written, here and below.
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
    buffer_ += fmt::format(format, std::forward<Values>(values)...);
    buffer_.push_back('\n');
    if (buffer_.size() > std::size_t{1} << 16) flush();
  }

  /// Completes the file. To be called last.
  void close();

 private:
  void flush();
  [[noreturn]] void fail() const;
  std::string path_, place_;
  std::optional<Leftover> half_;
  std::FILE* file_ = nullptr;
  std::string buffer_;
};

/// Makes the folder where it is not there. InputError if it cannot.
void make_folder(const std::string& path);
/// Writes such a file that is `text` alone: it always holds the whole old text or the whole new
/// one, even if the writer is killed, where it is a regular file or was none.
void write_file(const std::string& path, const std::string& text);

}  // namespace cosim
