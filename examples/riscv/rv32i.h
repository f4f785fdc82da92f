// An instruction-set simulator of RV32I: the golden model of single.v, clock by clock, and the
// reference for the retirements of core.v.
#pragma once

#include <cosim/model.h>

struct Rv32i {
  using Word = Hex<UInt<32>>;
  struct In {
    Bit rst;
    Word insn;   // the instruction at pc
    Word rdata;  // the word at mem_addr
  };
  struct Out {
    Word pc;             // of this instruction
    Bit trap;            // it traps, and changes nothing
    UInt<5> rd;          // the register that it writes, 0: none
    Word rd_data;        // what it writes there, 0 where rd is 0
    Word next_pc;        // of the next one
    Word mem_addr;       // of the word that it loads from or stores to, else 0
    Hex<UInt<4>> rmask;  // the bytes that it loads
    Hex<UInt<4>> wmask;  // the bytes that it stores
    Word wdata;          // what it stores, 0 in all other bytes
  };
  static constexpr auto reset = active_high<&In::rst>;
  static constexpr int trap_pc = 4;

  Word pc = 0;
  Array<Word, 31> x = 0;  // x1 to x31

  Out clock(const In& in) {
    const Out out = executed(in.insn, in.rdata);
    if (in.rst) {
      *this = Rv32i{};
    } else {
      pc = out.next_pc;
      if (out.rd != 0) x[UInt<5>(out.rd - 1)] = out.rd_data;
    }
    return out;
  }

 private:
  Out executed(const Word& insn, const Word& rdata) const {
    const UInt<5> rd = insn.slice<11, 7>();
    const UInt<3> funct3 = insn.slice<14, 12>();
    const UInt<7> funct7 = insn.slice<31, 25>();
    const UInt<32> a = value_of(insn.slice<19, 15>());
    const UInt<32> b = value_of(insn.slice<24, 20>());
    const Int<12> immediate = Int<12>(insn.slice<31, 20>());
    const Int<12> immediate_of_store = Int<12>(cat(insn.slice<31, 25>(), insn.slice<11, 7>()));
    const UInt<32> upper = insn & 0xfffff000;
    // Of the codes that differ in bit 5 alone.
    const UInt<32> right = mux(insn[5], b, immediate);
    const UInt<32> address = a + mux(insn[5], immediate_of_store, immediate);

    switch (insn.slice<6, 0>().value()) {
      case 0x37:
        return writes(rd, upper);  // LUI
      case 0x17:
        return writes(rd, pc + upper);  // AUIPC
      case 0x6f: {                      // JAL
        const auto offset =
            cat(insn[31], insn.slice<19, 12>(), insn[20], insn.slice<30, 21>(), Bit(0));
        return jumps(rd, pc + Int<21>(offset));
      }
      case 0x67:  // JALR
        return funct3 == 0 ? jumps(rd, (a + immediate) & ~UInt<32>(1)) : traps();
      case 0x63: {  // BEQ and the others
        const auto offset =
            cat(insn[31], insn[7], insn.slice<30, 25>(), insn.slice<11, 8>(), Bit(0));
        if (funct3 == 2 || funct3 == 3) return traps();
        return branches(funct3, a, right) ? jumps(0, pc + Int<13>(offset)) : writes(0, 0);
      }
      case 0x03:
        return loads(funct3, rd, address, rdata);
      case 0x23:
        return stores(funct3, address, b);
      case 0x13:    // ADDI and the others
      case 0x33: {  // ADD and the others
        const Bit is_right_shift = funct3 == 5;
        const Bit has_other = is_right_shift || (funct3 == 0 && insn[5]);
        const Bit has_funct7 = insn[5] || is_right_shift || funct3 == 1;
        const Bit other = has_other && funct7 == 0x20;
        if (has_funct7 && funct7 != 0 && !other) return traps();
        return writes(rd, arithmetic(funct3, other, a, right));
      }
      case 0x0f:
        return funct3 == 0 ? writes(0, 0) : traps();  // FENCE
    }
    return traps();
  }

  UInt<32> value_of(const UInt<5>& r) const { return mux(r == 0, 0, x[UInt<5>(r - 1)]); }

  static Bit branches(const UInt<3>& funct3, const UInt<32>& a, const UInt<32>& b) {
    const Bit less = mux(funct3[1], a < b, Int<32>(a) < Int<32>(b));
    return mux(funct3[2], less, a == b) != funct3[0];
  }

  /// `other`: SUB in place of ADD, SRA in place of SRL.
  static UInt<32> arithmetic(const UInt<3>& funct3, const Bit& other, const UInt<32>& a,
                             const UInt<32>& b) {
    const UInt<5> shift = b;
    switch (funct3.value()) {
      case 0:
        return mux(other, a - b, a + b);
      case 1:
        return a << shift;
      case 2:
        return Int<32>(a) < Int<32>(b);
      case 3:
        return a < b;
      case 4:
        return a ^ b;
      case 5:
        return mux(other, Int<32>(a) >> shift, a >> shift);
      case 6:
        return a | b;
    }
    return a & b;
  }

  Out loads(const UInt<3>& funct3, const UInt<5>& rd, const UInt<32>& address,
            const Word& rdata) const {
    const UInt<2> first = address;  // byte
    const UInt<32> word = rdata >> (first << 3);
    Out out = writes(rd, word);
    switch (funct3.value()) {
      case 0:
        out = writes(rd, Int<8>(word));
        break;
      case 1:
        out = writes(rd, Int<16>(word));
        break;
      case 2:
        break;
      case 4:
        out = writes(rd, UInt<8>(word));
        break;
      case 5:
        out = writes(rd, UInt<16>(word));
        break;
      default:
        return traps();
    }
    const UInt<2> size = funct3;
    if (is_misaligned(size, first)) return traps();
    out.mem_addr = address & ~UInt<32>(3);
    out.rmask = mask_of(size) << first;
    return out;
  }

  Out stores(const UInt<3>& funct3, const UInt<32>& address, const UInt<32>& value) const {
    const UInt<2> first = address, size = funct3;
    if (funct3 > 2 || is_misaligned(size, first)) return traps();
    Out out = writes(0, 0);
    out.mem_addr = address & ~UInt<32>(3);
    out.wmask = mask_of(size) << first;
    const UInt<32> bytes = mux(size == 0, UInt<8>(value), mux(size == 1, UInt<16>(value), value));
    out.wdata = bytes << (first << 3);
    return out;
  }

  static Bit is_misaligned(const UInt<2>& size, const UInt<2>& first) {
    return (size == 1 && first[0]) || (size == 2 && first != 0);
  }
  static UInt<4> mask_of(const UInt<2>& size) { return mux(size == 0, 1, mux(size == 1, 3, 15)); }

  Out writes(const UInt<5>& rd, const UInt<32>& value) const {
    return {.pc = pc,
            .trap = 0,
            .rd = rd,
            .rd_data = mux(rd == 0, 0, value),
            .next_pc = pc + 4,
            .mem_addr = 0,
            .rmask = 0,
            .wmask = 0,
            .wdata = 0};
  }
  Out jumps(const UInt<5>& rd, const UInt<32>& target) const {
    Out out = writes(rd, pc + 4);
    out.next_pc = target;
    return target[1] ? traps() : out;
  }
  Out traps() const {
    Out out = writes(0, 0);
    out.trap = 1;
    out.next_pc = trap_pc;
    return out;
  }
};
