// An executable in ELF, of 32 or 64 bits, made by hand.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace cosim::test {

struct ElfParts {
  int bits = 32;
  int type = 2;  // a static executable
  int machine = 243;
  std::uint64_t address = 0;
  std::vector<std::uint32_t> words;  // of the one segment, at the address
  std::uint64_t zeros = 0;           // bytes behind them in memory
  std::map<std::string, std::uint64_t> symbols;
};

/// Headers, segment, symbols, their names, two sections.
inline std::string elf_text(const ElfParts& parts) {
  const bool is_64 = parts.bits == 64;
  const int wide = parts.bits / 8;
  std::string text;
  const auto put = [&](std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i, value >>= 8) text += static_cast<char>(value & 0xff);
  };
  std::string names(1, '\0');
  const std::uint64_t begin = is_64 ? 64 + 56 : 52 + 32;
  const std::uint64_t bytes = 4 * parts.words.size(), symbol_bytes = is_64 ? 24 : 16;
  const std::uint64_t symbols = begin + bytes;
  const std::uint64_t strings = symbols + parts.symbols.size() * symbol_bytes;
  std::uint64_t end = strings + 1;
  for (const auto& [name, value] : parts.symbols) end += name.size() + 1;

  text = std::string(
             "\x7f"
             "ELF") +
         static_cast<char>(is_64 ? 2 : 1) + '\1' + '\1';
  text.resize(16);
  put(static_cast<std::uint64_t>(parts.type), 2);
  put(static_cast<std::uint64_t>(parts.machine), 2);
  put(1, 4);
  put(parts.address, wide);  // the entry
  put(is_64 ? 64 : 52, wide);
  put(end, wide);
  put(0, 4);
  for (const int one : {is_64 ? 64 : 52, is_64 ? 56 : 32, 1, is_64 ? 64 : 40, 2, 0}) {
    put(static_cast<std::uint64_t>(one), 2);
  }
  put(1, 4);
  if (is_64) put(7, 4);
  for (const std::uint64_t one :
       {begin, parts.address, parts.address, bytes, bytes + parts.zeros}) {
    put(one, wide);
  }
  if (!is_64) put(7, 4);
  put(1, wide);
  for (const std::uint32_t word : parts.words) put(word, 4);
  for (const auto& [name, value] : parts.symbols) {
    put(names.size(), 4);
    names += name + '\0';
    if (is_64) put(0, 4);
    put(value, wide);
    put(0, 8);
  }
  text += names;
  const auto section = [&](std::uint64_t type, std::uint64_t at, std::uint64_t size,
                           std::uint64_t link) {
    put(0, 4);
    put(type, 4);
    for (const std::uint64_t one : {std::uint64_t{0}, std::uint64_t{0}, at, size}) put(one, wide);
    put(link, 4);
    put(0, 4);
    put(1, wide);
    put(symbol_bytes, wide);
  };
  section(2, symbols, strings - symbols, 1);
  section(3, strings, end - strings, 0);
  return text;
}

}  // namespace cosim::test
