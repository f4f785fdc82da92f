// Instructions as random programs draw them: a code of a table, registers and an immediate.
#pragma once

#include <cosim/model.h>

#include <cstdint>
#include <iterator>

/// All instructions without their registers and immediates; 0 is one of any 32 bits. The first are
/// drawn most often, and shrinking turns an instruction into the very first.
inline constexpr std::uint32_t codes[] = {
    0x00000013, 0x00000033, 0x00002003, 0x00002023, 0x00000063,  // ADDI ADD LW SW BEQ
    0x00002013, 0x00003013, 0x00004013, 0x00006013, 0x00007013,  // SLTI SLTIU XORI ORI ANDI
    0x00001013, 0x00005013, 0x40005013, 0x00000037, 0x00000017,  // SLLI SRLI SRAI LUI AUIPC
    0x40000033, 0x00001033, 0x00002033, 0x00003033, 0x00004033,  // SUB SLL SLT SLTU XOR
    0x00005033, 0x40005033, 0x00006033, 0x00007033, 0x0000000f,  // SRL SRA OR AND FENCE
    0x00000003, 0x00001003, 0x00004003, 0x00005003, 0x00000023, 0x00001023,  // LB LH LBU LHU SB SH
    0x0000006f, 0x00000067, 0x00001063, 0x00004063, 0x00005063,              // JAL JALR BNE BLT BGE
    0x00006063, 0x00007063, 0x00000073, 0x00100073, 0x00000000};  // BLTU BGEU ECALL EBREAK

/// The instruction; fields that its kind does not have are ignored. A branch or JAL is to a
/// multiple of 4 unless bits 0 and 1 of the immediate are set: another target traps.
inline UInt<32> encoded(const UInt<6>& code, const UInt<5>& rd, const UInt<5>& rs1,
                        const UInt<5>& rs2, const UInt<32>& immediate) {
  Array<UInt<32>, std::size(codes)> table = 0;
  for (int i = 0; i < static_cast<int>(std::size(codes)); ++i) table[i] = codes[i];
  UInt<32> insn = table[code];
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
