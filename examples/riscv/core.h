// Golden model of core.v, without clocks. Each transaction is an instruction, with the word that it
// loads if it loads one; the accesses to the bus and the retirements come out.
#pragma once

#include <cosim/program.h>
#include <cosim/stream.h>

#include <string>
#include <utility>

#include "program.h"
#include "rv32i.h"

struct Core {
  using Word = Hex<UInt<32>>;
  struct Step {
    Enum<Operation> op;
    UInt<5> rd, rs1, rs2;
    Word immediate;
    Word loaded;    // the word that it loads, if it loads one
    UInt<3> waits;  // clocks for which a load or a store is not answered

    UInt<32> instruction() const {
      return encoded(static_cast<Operation>(op), rd, rs1, rs2, immediate);
    }
  };
  struct Access {
    Bit fetch;  // of an instruction
    Word addr;
    Hex<UInt<4>> wmask;
    Word wdata;
  };
  struct Retired {
    UInt<32> order;
    Word insn;
    Bit trap;
    Word pc, next_pc;
    UInt<5> rd;
    Word rd_data;
    Word mem_addr;
    Hex<UInt<4>> rmask, wmask;
    Word mem_data;  // the word that it read, or what it stored
  };

  /// Answers a fetch with the next instruction, and its load or store after it. A fetch waits for
  /// as long as the case holds the instruction back.
  struct Memory {
    struct Drives {
      Bit bus_ready = 0;
      UInt<32> bus_rdata = 0x5a5a5a5a;
    };
    struct Reads {
      Bit bus_valid, bus_fetch;
    };
    const Step* next = nullptr;      // may be fetched
    const Step* executed = nullptr;  // was fetched: the record stays until the case ends
    bool is_ready = false;
    bool waits_for_fetch = false, waits_for_data = false;  // the core, since the clock before
    int waited = 0;

    Drives drive(const Step* step) {
      next = step;
      Drives pins;
      if (waits_for_fetch && next != nullptr) {
        pins = {1, next->instruction()};
      } else if (waits_for_data && executed != nullptr && executed->waits <= waited) {
        pins = {1, executed->loaded};
      }
      is_ready = bool(pins.bus_ready);
      return pins;
    }
    bool took(const Reads& pins) {
      const bool is_valid(pins.bus_valid), is_fetch(pins.bus_fetch);
      const bool passes = is_valid && is_ready;
      const bool fetches = passes && is_fetch;
      if (fetches) executed = next;
      waited = waits_for_data ? waited + 1 : 0;
      waits_for_fetch = is_valid && is_fetch && !passes;
      waits_for_data = is_valid && !is_fetch && !passes;
      return fetches;
    }
  };

  /// Sees each access on the clock on which it passes.
  struct Bus {
    struct Reads {
      Bit bus_valid, bus_ready, bus_fetch;
      UInt<32> bus_addr;
      UInt<4> bus_wmask;
      UInt<32> bus_wdata;
    };
    std::optional<Access> came(const Reads& pins) {
      if (!pins.bus_valid || !pins.bus_ready) return {};
      return Access{pins.bus_fetch, pins.bus_addr, pins.bus_wmask, pins.bus_wdata};
    }
  };

  static constexpr auto in() { return stream<Step, Memory>("step"); }
  static constexpr auto out() {
    return std::tuple{stream<Access, Bus>("access"), stream<Retired>("retired").always_ready()};
  }
  static constexpr auto pins() { return std::array{pin::reset("rst")}; }

  /// Half of the programs use few registers, so that an instruction meets what another one wrote;
  /// immediates are small ones, or any.
  static auto draws() {
    return std::tuple{drawn(&Step::rd, {{0, 3, 3}, {0, 31, 1}}),
                      drawn(&Step::rs1, {{0, 3, 3}, {0, 31, 1}}),
                      drawn(&Step::rs2, {{0, 3, 3}, {0, 31, 1}}),
                      drawn(&Step::immediate, {{0, 31, 1}, 4, any(2)})};
  }

  static std::string text_of(const Step& step) {
    return ::text_of(step.op, step.rd, step.rs1, step.rs2, step.immediate);
  }
  static std::string state_after(const std::vector<Step>& steps) {
    Rv32i simulator;
    for (const Step& step : steps) {
      simulator.clock({.rst = 0, .insn = step.instruction(), .rdata = step.loaded});
    }
    std::string text = "pc " + hexadecimal(simulator.pc);
    for (int i = 0; i < 31; ++i) {
      if (simulator.x[i] == 0) continue;
      text += ", x" + std::to_string(i + 1) + ' ' + hexadecimal(simulator.x[i]);
    }
    return text;
  }

  /// What must have happened before the core is believed: each operation, each kind of it with
  /// and without a trap, and the corners of jumps, waits and results that are used at once.
  static auto cases(const Step& step) { return values(step.op); }
  static auto cases(const Retired& r, const Retired* before) {
    const UInt<7> opcode = r.insn.slice<6, 0>();
    const Bit loads = opcode == 0x03, stores = opcode == 0x23, branches = opcode == 0x63;
    const Bit jumps = opcode == 0x6f || opcode == 0x67;
    const Bit follows_a_load = before != nullptr ? before->rmask != 0 && before->rd != 0 : Bit(0);
    const Bit uses_it = before != nullptr ? r.insn.slice<19, 15>() == before->rd : Bit(0);
    return std::tuple{
        crossed(stated({{"a load", loads},
                        {"a store", stores},
                        {"a branch", branches},
                        {"a jump", jumps},
                        {"another", !(loads || stores || branches || jumps)}}),
                stated({{"traps", r.trap}, {"does not trap", !r.trap}})),
        stated({{"a branch by 4",
                 branches && !r.trap && r.insn.slice<31, 25>() == 0 && r.insn.slice<11, 7>() == 4},
                {"a branch back that is taken", branches && r.next_pc < r.pc && !r.trap},
                {"a jump to itself", jumps && r.next_pc == r.pc},
                {"a load whose result the next instruction reads", follows_a_load && uses_it},
                {"a store behind a load", follows_a_load && stores}})};
  }

  /// The instructions of a test program in ELF that begins at 0, as far as the ISS executes it.
  static std::pair<std::vector<Step>, std::string> program(const std::string& path) {
    constexpr int riscv = 243;
    constexpr std::size_t most = 100'000;
    cosim::Program program(path, riscv);
    if (program.elf().entry != 0) throw cosim::InputError(path + ": does not begin at address 0");
    std::vector<Step> steps;
    Rv32i simulator;
    const auto word = [&](const UInt<32>& at) {
      return UInt<32>(program.memory.read(at.value(), 4));
    };
    while (!program.has_ended() && steps.size() < most) {
      const UInt<32> insn = word(simulator.pc);
      const UInt<32> loads_from = Rv32i(simulator).clock({0, insn, 0}).mem_addr;
      const UInt<32> loaded = word(loads_from);
      const Rv32i::Out did = simulator.clock({0, insn, loaded});
      for (int byte = 0; byte < 4; ++byte) {
        if (!did.wmask[byte]) continue;
        program.memory.write(did.mem_addr.value() + byte, (did.wdata >> 8 * byte).value(), 1);
      }
      const Operation op = operation_of(insn);
      steps.push_back({.op = op,
                       .rd = insn.slice<11, 7>(),
                       .rs1 = insn.slice<19, 15>(),
                       .rs2 = insn.slice<24, 20>(),
                       .immediate = op == Operation::other ? insn : immediate_of(insn),
                       .loaded = loaded,
                       .waits = steps.size() % 4});
    }
    return {steps, program.wrong()};
  }

  static std::tuple<std::vector<Access>, std::vector<Retired>> run(const std::vector<Step>& steps) {
    std::vector<Access> accesses;
    std::vector<Retired> retired;
    Rv32i simulator;
    for (const Step& step : steps) {
      const UInt<32> insn = step.instruction();
      const Rv32i::Out did = simulator.clock({.rst = 0, .insn = insn, .rdata = step.loaded});
      accesses.push_back({.fetch = 1, .addr = did.pc, .wmask = 0, .wdata = 0});
      const bool loads = did.rmask != 0;
      if (loads || did.wmask != 0) accesses.push_back({0, did.mem_addr, did.wmask, did.wdata});
      retired.push_back({.order = retired.size(),
                         .insn = insn,
                         .trap = did.trap,
                         .pc = did.pc,
                         .next_pc = did.next_pc,
                         .rd = did.rd,
                         .rd_data = did.rd_data,
                         .mem_addr = did.mem_addr,
                         .rmask = did.rmask,
                         .wmask = did.wmask,
                         .mem_data = loads ? step.loaded : did.wdata});
    }
    return {accesses, retired};
  }
};
