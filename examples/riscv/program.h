// Instructions as random programs draw them, an operation, registers and an immediate; and as the
// words that they are in memory.
#pragma once

#include <cosim/stream.h>

#include <cstdint>
#include <cstdio>
#include <string>

/// The instructions; `other` is one of any 32 bits. Shrinking turns one into the very first.
// clang-format off
enum class Operation {
  addi, slti, sltiu, xori, ori, andi, slli, srli, srai,      // with an immediate
  add, sub, sll, slt, sltu, xor_, srl, sra, or_, and_,       // of two registers
  lb, lh, lw, lbu, lhu, sb, sh, sw,
  beq, bne, blt, bge, bltu, bgeu, jal, jalr,
  lui, auipc, fence, ecall, ebreak, other
};
// clang-format on

/// Each without its registers and its immediate.
inline constexpr std::uint32_t codes[] = {
    0x00000013, 0x00002013, 0x00003013, 0x00004013, 0x00006013, 0x00007013,
    0x00001013, 0x00005013, 0x40005013,  // addi to srai
    0x00000033, 0x40000033, 0x00001033, 0x00002033, 0x00003033, 0x00004033,
    0x00005033, 0x40005033, 0x00006033, 0x00007033,  // add to and_
    0x00000003, 0x00001003, 0x00002003, 0x00004003, 0x00005003, 0x00000023,
    0x00001023, 0x00002023,  // lb to sw
    0x00000063, 0x00001063, 0x00004063, 0x00005063, 0x00006063, 0x00007063,
    0x0000006f, 0x00000067,  // beq to jalr
    0x00000037, 0x00000017, 0x0000000f, 0x00000073, 0x00100073, 0x00000000};

/// The instruction; fields that its kind does not have are ignored. A branch or JAL is to a
/// multiple of 4 unless bits 0 and 1 of the immediate are set: another target traps.
inline UInt<32> encoded(Operation op, const UInt<5>& rd, const UInt<5>& rs1, const UInt<5>& rs2,
                        const UInt<32>& immediate) {
  UInt<32> insn = codes[static_cast<int>(op)];
  UInt<32> offset = immediate;
  offset[1] = offset[1] && offset[0];
  const UInt<32> to_rd = rd << 7, from_rs1 = rs1 << 15, from_rs2 = rs2 << 20;
  switch (insn.slice<6, 0>().value()) {
    case 0x13:
      if (insn[12] && !insn[13]) return insn | UInt<5>(immediate) << 20 | from_rs1 | to_rd;
      return insn | UInt<12>(immediate) << 20 | from_rs1 | to_rd;
    case 0x03:
    case 0x0f:
    case 0x67:
      return insn | UInt<12>(immediate) << 20 | from_rs1 | to_rd;
    case 0x33:
      return insn | from_rs2 | from_rs1 | to_rd;
    case 0x23:
      insn.slice<31, 25>() = immediate.slice<11, 5>();
      insn.slice<11, 7>() = immediate.slice<4, 0>();
      return insn | from_rs2 | from_rs1;
    case 0x63:
      insn.slice<31, 25>() = cat(offset[12], offset.slice<10, 5>());
      insn.slice<11, 7>() = cat(offset.slice<4, 1>(), offset[11]);
      return insn | from_rs2 | from_rs1;
    case 0x17:
    case 0x37:
      return insn | (immediate & 0xfffff000) | to_rd;
    case 0x6f:
      insn.slice<31, 12>() =
          cat(offset[20], offset.slice<10, 1>(), offset[11], offset.slice<19, 12>());
      return insn | to_rd;
    case 0x73:
      return insn;
  }
  return immediate;
}

/// The immediate of an instruction, sign-extended; 0 if its kind has none.
inline UInt<32> immediate_of(const UInt<32>& insn) {
  switch (insn.slice<6, 0>().value()) {
    case 0x13:
      if (insn[12] && !insn[13]) return insn.slice<24, 20>();
      return Int<12>(insn.slice<31, 20>());
    case 0x03:
    case 0x0f:
    case 0x67:
      return Int<12>(insn.slice<31, 20>());
    case 0x23:
      return Int<12>(cat(insn.slice<31, 25>(), insn.slice<11, 7>()));
    case 0x63:
      return Int<13>(cat(insn[31], insn[7], insn.slice<30, 25>(), insn.slice<11, 8>(), Bit(0)));
    case 0x17:
    case 0x37:
      return insn & 0xfffff000;
    case 0x6f:
      return Int<21>(cat(insn[31], insn.slice<19, 12>(), insn[20], insn.slice<30, 21>(), Bit(0)));
  }
  return 0;
}

/// The operation of an instruction; `other` if there is none.
inline Operation operation_of(const UInt<32>& insn) {
  for (int i = 0; i < static_cast<int>(Operation::other); ++i) {
    const auto op = static_cast<Operation>(i);
    const UInt<32> same = encoded(op, insn.slice<11, 7>(), insn.slice<19, 15>(),
                                  insn.slice<24, 20>(), immediate_of(insn));
    if (same == insn) return op;
  }
  return Operation::other;
}

inline std::string hexadecimal(const UInt<32>& word) {
  char text[11];
  std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(word.value()));
  return text;
}

/// The instruction as an assembler has it; fields that its kind does not have are left out.
inline std::string text_of(const Enum<Operation>& op, const UInt<5>& rd, const UInt<5>& rs1,
                           const UInt<5>& rs2, const UInt<32>& immediate) {
  const auto x = [](const UInt<5>& number) { return "x" + std::to_string(number.value()); };
  const UInt<32> insn = encoded(static_cast<Operation>(op), rd, rs1, rs2, immediate);
  const std::string name = std::string(op.name()) + ' ';
  const std::string number = std::to_string(Int<12>(UInt<12>(immediate)).value());
  const std::string offset = std::to_string(Int<32>(immediate_of(insn)).value());
  switch (insn.slice<6, 0>().value()) {
    case 0x13:
      return name + x(rd) + ", " + x(rs1) + ", " +
             (insn[12] && !insn[13] ? std::to_string(UInt<5>(immediate).value()) : number);
    case 0x33:
      return name + x(rd) + ", " + x(rs1) + ", " + x(rs2);
    case 0x03:
    case 0x67:
      return name + x(rd) + ", " + number + '(' + x(rs1) + ')';
    case 0x23:
      return name + x(rs2) + ", " + number + '(' + x(rs1) + ')';
    case 0x63:
      return name + x(rs1) + ", " + x(rs2) + ", . + " + offset;
    case 0x6f:
      return name + x(rd) + ", . + " + offset;
    case 0x17:
    case 0x37:
      return name + x(rd) + ", 0x" + hexadecimal(insn >> 12).substr(3);
  }
  return op == Operation::other ? ".word 0x" + hexadecimal(insn) : op.name();
}
