// An FST file being written.
#pragma once

#include <gtkwave/fstapi.h>

#include <cstdint>
#include <map>
#include <string>

#include "model/core/value.h"
#include "tb/util/leftover.h"

namespace cosim {

/// Scopes and variables first, then times and values. A value stays until the next one.
class Fst {
 public:
  using Handle = std::uint32_t;

  /// InputError where the file cannot be written, here, in time() and in close().
  explicit Fst(const std::string& path);
  ~Fst();
  Fst(const Fst&) = delete;
  Fst& operator=(const Fst&) = delete;

  void open_scope(const std::string& name);
  void close_scope();
  /// A variable of `width` bits; `range` as "[7:4]", else they are counted from 0.
  Handle variable(const std::string& name, int width, const std::string& range = "");
  /// A variable that holds a real number.
  Handle real(const std::string& name);

  /// A variable that holds text.
  Handle text(const std::string& name);

  /// In nanoseconds; rising.
  void time(std::uint64_t t);
  /// The low `width` bits of `value`, width <= 64.
  void value(Handle handle, int width, Word value);
  /// `width` bits of any number, the lowest byte first.
  void bytes(Handle handle, int width, const unsigned char* bytes);
  void number(Handle handle, double number);
  void text(Handle handle, const std::string& text);

  /// Completes the file. To be called last.
  void close();

 private:
  std::string path_;
  Leftover half_, hierarchy_;  // what the writer writes, and what it puts beside that meanwhile
  decltype(fstWriterCreate(nullptr, 0)) writer_ = nullptr;  // another type in newer libraries
  std::string digits_;
  std::map<Handle, std::string> texts_;  // as they are now
};

}  // namespace cosim
