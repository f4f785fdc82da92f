// Programs in ELF: what is loaded, how they end, and what is refused.
#include "model/core/program.h"

#include <gtest/gtest.h>

#include "tests/support/elf.h"
#include "tests/support/error_of.h"
#include "tests/support/folder.h"

namespace cosim::test {
namespace {

class Programs : public InAFolder {
 protected:
  std::string file() const { return folder.write("a.elf", elf_text(parts)); }
  std::string refused() const {
    const std::string path = file();
    const std::string line = error_of([&] { Program(path, 243); });
    return line.starts_with(path + ": ") ? line.substr(path.size() + 2) : line;
  }
  ElfParts parts{
      .address = 0x80000000,
      .words = {0x01020304, 0xfffefdfc},
      .zeros = 0x1000,
      .symbols = {
          {"begin_signature", 0x80000004}, {"end_signature", 0x8000000c}, {"tohost", 0x80000100}}};
};

TEST_F(Programs, AreLoaded) {
  for (const int bits : {32, 64}) {
    parts.bits = bits;
    Program program(file(), 243);
    EXPECT_EQ(program.elf().bits, bits);
    EXPECT_EQ(program.elf().entry, 0x80000000U);
    EXPECT_EQ(program.elf().symbols.at("tohost"), 0x80000100U);
    ASSERT_EQ(program.elf().segments.size(), 1U);
    EXPECT_EQ(program.elf().segments.front().bytes.size(), 8U);
    EXPECT_EQ(program.memory.read(0x80000000, 8), 0xfffefdfc01020304U);
    EXPECT_EQ(program.memory.read(0x80000003, 2), 0xfc01U);
    EXPECT_EQ(program.memory.read(0x1234, 4), 0U);
    program.memory.write(0x80000fff, 0xabcd, 2);
    EXPECT_EQ(program.memory.read(0x80000ffe, 4), 0x00abcd00U);
  }
}

TEST_F(Programs, EndByToHost) {
  for (const int bits : {32, 64}) {
    parts.bits = bits;
    Program program(file(), 243);
    EXPECT_FALSE(program.has_ended());
    EXPECT_EQ(program.wrong(), "tohost is 0: the program has not ended");
    program.memory.write(0x80000100, 1, 4);
    EXPECT_TRUE(program.has_ended());
    EXPECT_EQ(program.wrong(), "");
    program.memory.write(0x80000100, 11, 4);
    EXPECT_EQ(program.wrong(), "tohost: test 5 fails");
    program.memory.write(0x80000100, 12, 4);
    EXPECT_EQ(program.wrong(), "tohost is 12, a system call, which has no host");
  }
}

TEST_F(Programs, LeaveASignature) {
  Program program(file(), 243);
  program.memory.write(0x80000100, 1, 4);
  const std::string path = folder.path("a.elf.signature");
  folder.write("a.elf.signature", "fffefdfc\n00000000\n");
  EXPECT_EQ(program.wrong(), "");
  folder.write("a.elf.signature", "fffefdfc\n00000001\n");
  EXPECT_EQ(program.wrong(), "signature: word 1 is 00000000, and 00000001 in " + path);
  folder.write("a.elf.signature", "fffefdfc\n");
  EXPECT_EQ(program.wrong(), "signature: " + path + " has too few words");
  folder.write("a.elf.signature", "fffefdfc\n00000000\n00000000\n");
  EXPECT_EQ(program.wrong(), "signature: " + path + " has too many words");
}

TEST_F(Programs, AreRefusedInALine) {
  EXPECT_EQ(refused(), "");
  parts.machine = 62;
  EXPECT_EQ(refused(), "is for ELF machine 62, not 243");
  parts.machine = 243;
  parts.type = 1;
  EXPECT_EQ(refused(), "is no static executable, but an object or a shared library");
  parts.type = 2;
  parts.symbols.erase("tohost");
  EXPECT_EQ(refused(), "has no symbol tohost, which ends a program");
}

TEST_F(Programs, AreRefusedWhereTheFileIsNone) {
  const auto refused_text = [&](const std::string& text) {
    const std::string path = folder.write("b.elf", text);
    return error_of([&] { read_elf(path); }).substr(path.size() + 2);
  };
  const std::string missing = folder.path("missing");
  EXPECT_EQ(error_of([&] { read_elf(missing); }),
            missing + ": is no file that can be read, or is empty");
  EXPECT_EQ(refused_text(""), "is no file that can be read, or is empty");
  EXPECT_EQ(refused_text("#!/bin/sh\n"), "is no ELF file");
  std::string big = elf_text(parts);
  big[5] = 2;
  EXPECT_EQ(refused_text(big), "is big-endian; only little-endian files are read");
  // Wherever it is cut off; the last 20 bytes are not read.
  const std::string whole = elf_text(parts);
  for (std::size_t n = 6; n < whole.size() - 20; ++n) {
    EXPECT_EQ(refused_text(whole.substr(0, n)), "is cut off, or no valid ELF file") << n;
  }
}

}  // namespace
}  // namespace cosim::test
