// Static executables in ELF, of 32 or 64 bits, little-endian.
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "model/core/input_error.h"

namespace cosim {

struct Elf {
  struct Segment {
    std::uint64_t address = 0;        ///< physical, of the first byte
    std::vector<std::uint8_t> bytes;  ///< that the file has; behind them memory is 0
  };
  int bits = 32;    ///< of an address: 32 or 64
  int machine = 0;  ///< the processor, as ELF numbers it; RISC-V: 243
  std::uint64_t entry = 0;
  std::vector<Segment> segments;  ///< that are loaded
  std::map<std::string, std::uint64_t> symbols;
};

namespace detail {

class ElfReader {
 public:
  explicit ElfReader(const std::string& path) : path_(path) {
    std::ifstream file(path, std::ios::binary);
    file_.assign(std::istreambuf_iterator<char>(file), {});
    if (!file || file_.empty()) refuse("is no file that can be read, or is empty");
    if (file_.substr(0, 4) != "\177ELF") refuse("is no ELF file");
    is_64_ = number(4, 1) == 2;
    if (number(5, 1) != 1) refuse("is big-endian; only little-endian files are read");
    if (number(16, 2) != 2) refuse("is no static executable, but an object or a shared library");
  }
  Elf read() const {
    Elf elf;
    elf.bits = is_64_ ? 64 : 32;
    elf.machine = static_cast<int>(number(18, 2));
    elf.entry = address(24);
    std::uint64_t bytes = 0;
    for_each(address(is_64_ ? 32 : 28), is_64_ ? 54 : 42, [&](std::uint64_t header) {
      if (number(header, 4) != loaded) return;
      elf.segments.push_back(segment(header));
      check(0, bytes += elf.segments.back().bytes.size());  // they do not overlap
    });
    for_each(address(is_64_ ? 40 : 32), is_64_ ? 58 : 46, [&](std::uint64_t header) {
      if (number(header + 4, 4) != symbol_table || !elf.symbols.empty()) return;
      read_symbols(header, elf);
    });
    return elf;
  }

 private:
  static constexpr std::uint64_t loaded = 1, symbol_table = 2;

  [[noreturn]] void refuse(const std::string& why) const { throw InputError(path_ + ": " + why); }
  void check(std::uint64_t at, std::uint64_t bytes) const {
    if (at > file_.size() || bytes > file_.size() - at) refuse("is cut off, or no valid ELF file");
  }
  std::uint64_t number(std::uint64_t at, int bytes) const {
    check(at, static_cast<std::uint64_t>(bytes));
    std::uint64_t value = 0;
    for (int i = bytes; i-- > 0;) {
      value = value << 8 | static_cast<std::uint8_t>(file_[at + static_cast<std::uint64_t>(i)]);
    }
    return value;
  }
  std::uint64_t address(std::uint64_t at) const { return number(at, is_64_ ? 8 : 4); }

  /// Visits the headers of a table: their size is at `size`, and their number behind it.
  template <class Visit>
  void for_each(std::uint64_t table, std::uint64_t size, const Visit& visit) const {
    for (std::uint64_t i = 0; i < number(size + 2, 2); ++i) visit(table + i * number(size, 2));
  }
  Elf::Segment segment(std::uint64_t header) const {
    const std::uint64_t at = address(header + (is_64_ ? 8 : 4));
    const std::uint64_t in_file = address(header + (is_64_ ? 32 : 16));
    check(at, in_file);
    Elf::Segment s{address(header + (is_64_ ? 24 : 12)), {}};
    const auto begin = file_.begin() + static_cast<std::ptrdiff_t>(at);
    s.bytes.assign(begin, begin + static_cast<std::ptrdiff_t>(in_file));
    return s;
  }
  void read_symbols(std::uint64_t header, Elf& elf) const {
    const std::uint64_t at = address(header + (is_64_ ? 24 : 16));
    const std::uint64_t bytes = address(header + (is_64_ ? 32 : 20));
    const std::uint64_t names_header =
        address(is_64_ ? 40 : 32) +
        number(header + (is_64_ ? 40 : 24), 4) * number(is_64_ ? 58 : 46, 2);
    const std::uint64_t names = address(names_header + (is_64_ ? 24 : 16));
    check(at, bytes);
    const std::uint64_t size = is_64_ ? 24 : 16;
    for (std::uint64_t i = 0; i < bytes / size; ++i) {
      const std::uint64_t symbol = at + i * size, name = names + number(symbol, 4);
      check(name, 1);
      const std::size_t end = file_.find('\0', name);
      check(end, 1);
      elf.symbols[file_.substr(name, end - name)] = address(symbol + (is_64_ ? 8 : 4));
    }
  }

  std::string path_, file_;
  bool is_64_ = false;
};

}  // namespace detail

/// InputError where the file cannot be read, or is none of these.
inline Elf read_elf(const std::string& path) { return detail::ElfReader(path).read(); }

}  // namespace cosim
