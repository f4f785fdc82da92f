// An instruction-set simulator of RV32I: one instruction a clock, no traps.
#pragma once

#include "model/clocked/model.h"

namespace cosim::clocked::test {

struct Rv32i {
  struct In {
    Bit rst;
    UInt<32> insn;   // at pc
    UInt<32> rdata;  // at addr, its byte in the lowest place
  };
  struct Out {
    UInt<32> pc, addr, wdata;
    UInt<4> we;  // of bytes from addr on
  };
  enum Opcode {
    lui = 0x37,
    auipc = 0x17,
    jal = 0x6f,
    jalr = 0x67,
    branch = 0x63,
    load = 0x03,
    store = 0x23,
    op_imm = 0x13,
    op = 0x33
  };

  UInt<32> pc = 0;
  Unreset<Array<UInt<32>, 32>> x;

  static UInt<32> computed(const UInt<3>& f3, const Bit& alt, const UInt<32>& a,
                           const UInt<32>& b) {
    const UInt<5> by = b;
    const Int<32> sa = a, sb = b;
    if (f3 == 0) return mux(alt, a - b, a + b);
    if (f3 == 1) return a << by;
    if (f3 == 2) return sa < sb;
    if (f3 == 3) return a < b;
    if (f3 == 4) return a ^ b;
    if (f3 == 5) return mux(alt, UInt<32>(sa >> by), a >> by);
    if (f3 == 6) return a | b;
    return a & b;
  }
  static Bit is_taken(const UInt<3>& f3, const UInt<32>& a, const UInt<32>& b) {
    Bit less = a < b;
    if (!f3[1]) less = Int<32>(a) < Int<32>(b);
    return mux(f3[2], less, a == b) != f3[0];
  }
  static UInt<32> loaded(const UInt<3>& f3, const UInt<32>& data) {
    if (f3 == 0) return Int<8>(data);
    if (f3 == 1) return Int<16>(data);
    if (f3 == 4) return UInt<8>(data);
    if (f3 == 5) return UInt<16>(data);
    return data;
  }

  Out clock(const In& in) {
    Out out{.pc = pc, .addr = 0, .wdata = 0, .we = 0};
    if (in.rst) {
      pc = 0;
      return out;
    }
    const UInt<32> i = in.insn;
    const auto opcode = i.slice<6, 0>();
    const auto rd = i.slice<11, 7>();
    const auto f3 = i.slice<14, 12>();
    const UInt<32> a = x[i.slice<19, 15>()], b = x[i.slice<24, 20>()];
    const Int<12> imm_i(i.slice<31, 20>()), imm_s(cat(i.slice<31, 25>(), rd));
    const Int<13> imm_b(cat(i[31], i[7], i.slice<30, 25>(), i.slice<11, 8>(), Bit(0)));
    const Int<21> imm_j(cat(i[31], i.slice<19, 12>(), i[20], i.slice<30, 21>(), Bit(0)));
    const UInt<32> imm_u(cat(i.slice<31, 12>(), UInt<12>(0)));

    UInt<32> next = pc + 4, result = 0;
    bool writes = true;
    if (opcode == lui) {
      result = imm_u;
    } else if (opcode == auipc) {
      result = pc + imm_u;
    } else if (opcode == jal) {
      result = pc + 4;
      next = pc + imm_j;
    } else if (opcode == jalr) {
      result = pc + 4;
      next = (a + imm_i) & ~1;
    } else if (opcode == branch) {
      writes = false;
      if (is_taken(f3, a, b)) next = pc + imm_b;
    } else if (opcode == load) {
      out.addr = a + imm_i;
      result = loaded(f3, in.rdata);
    } else if (opcode == store) {
      writes = false;
      out.addr = a + imm_s;
      out.wdata = b;
      out.we = f3 == 0 ? 1 : f3 == 1 ? 3 : 15;
    } else if (opcode == op_imm) {
      result = computed(f3, f3 == 5 && i[30], a, imm_i);
    } else if (opcode == op) {
      result = computed(f3, i[30], a, b);
    } else {
      writes = false;
    }
    if (writes && rd != 0) x[rd] = result;
    pc = next;
    return out;
  }
};

}  // namespace cosim::clocked::test
