// Test programs for a processor: an ELF file in the memory of a simulator, and how it ends. It has
// the symbols that the RISC-V test suites have:
//
//   tohost                            the program ends when this is not 0: 1 is a pass, another odd
//                                     number is 2 * the number of the test that fails + 1
//   begin_signature, end_signature    optional: what it leaves there, compared with FILE.signature,
//                                     if that exists: 32 bits a line, 8 hexadecimal digits
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <unordered_map>

#include "model/core/elf.h"

namespace cosim {

/// Bytes at any address, 0 where nothing was written.
class Memory {
 public:
  /// `bytes`, at most 8, from an address on, the first one the lowest.
  std::uint64_t read(std::uint64_t address, int bytes) const {
    std::uint64_t value = 0;
    for (int i = bytes; i-- > 0;) {
      const std::uint64_t at = address + static_cast<std::uint64_t>(i);
      const auto page = pages_.find(at / page_bytes);
      value = value << 8 | (page == pages_.end() ? 0 : page->second[at % page_bytes]);
    }
    return value;
  }
  void write(std::uint64_t address, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i, ++address, value >>= 8) {
      pages_[address / page_bytes][address % page_bytes] = static_cast<std::uint8_t>(value);
    }
  }

 private:
  static constexpr std::uint64_t page_bytes = 4096;
  std::unordered_map<std::uint64_t, std::array<std::uint8_t, page_bytes>> pages_;
};

class Program {
 public:
  Memory memory;

  /// Loads the file. `machine`: the processor, as ELF numbers it; RISC-V: 243. InputError where it
  /// is no program for it, or has no symbol tohost.
  Program(const std::string& path, int machine) : path_(path), elf_(read_elf(path)) {
    if (elf_.machine != machine) {
      throw InputError(path + ": is for ELF machine " + std::to_string(elf_.machine) + ", not " +
                       std::to_string(machine));
    }
    if (!elf_.symbols.contains("tohost")) {
      throw InputError(path + ": has no symbol tohost, which ends a program");
    }
    for (const Elf::Segment& s : elf_.segments) {
      for (std::size_t i = 0; i < s.bytes.size(); ++i) memory.write(s.address + i, s.bytes[i], 1);
    }
  }
  const Elf& elf() const { return elf_; }
  bool has_ended() const { return tohost() != 0; }

  /// What the program finds wrong, one line; empty where it passes.
  std::string wrong() const {
    const std::uint64_t end = tohost();
    if (end == 1) return wrong_signature();
    if (end == 0) return "tohost is 0: the program has not ended";
    if (end % 2 == 1) return "tohost: test " + std::to_string(end >> 1) + " fails";
    return "tohost is " + std::to_string(end) + ", a system call, which has no host";
  }

 private:
  std::uint64_t tohost() const { return memory.read(elf_.symbols.at("tohost"), elf_.bits / 8); }
  std::string wrong_signature() const {
    const auto begin = elf_.symbols.find("begin_signature"),
               end = elf_.symbols.find("end_signature");
    const std::string path = path_ + ".signature";
    std::ifstream file(path);
    if (!file || begin == elf_.symbols.end() || end == elf_.symbols.end()) return "";
    std::string expected;
    for (std::uint64_t at = begin->second; at < end->second; at += 4) {
      char actual[9];
      std::snprintf(actual, sizeof actual, "%08x", static_cast<unsigned>(memory.read(at, 4)));
      file >> expected;
      if (!file) return "signature: " + path + " has too few words";
      if (expected == actual) continue;
      return "signature: word " + std::to_string((at - begin->second) / 4) + " is " + actual +
             ", and " + expected + " in " + path;
    }
    return file >> expected ? "signature: " + path + " has too many words" : "";
  }

  std::string path_;
  Elf elf_;
};

}  // namespace cosim
