// What a master on the APB reads of apb.v for what it wrote: accesses in their order, without
// clocks.
#pragma once

#include <cosim/stream.h>

struct Apb {
  struct Access {
    Bit write;           // or it reads
    UInt<2> reg;         // which register
    Hex<UInt<32>> data;  // what is written
  };
  struct Result {
    Hex<UInt<32>> data;  // prdata on the clock of pready
  };

  /// Begins an access with psel, sets penable a clock later, and holds both until pready.
  struct Master {
    struct Drives {
      Bit psel = 0, penable = 0, pwrite = 0;
      UInt<4> paddr = 0;
      UInt<32> pwdata = 0;
    };
    struct Reads {
      Bit pready;
    };
    bool is_selected = false, is_enabled = false;

    Drives drive(const Access* access) {
      if (access == nullptr) return {};
      is_enabled = is_selected;
      is_selected = true;
      return {1, is_enabled, access->write, access->reg << 2, access->data};
    }
    bool took(const Reads& pins) {
      if (!is_enabled || !pins.pready) return false;
      is_selected = is_enabled = false;
      return true;
    }
  };

  /// Sees what is read; pready is only set on the last clock of an access.
  struct Reader {
    struct Reads {
      Bit pready;
      UInt<32> prdata;
    };
    std::optional<Result> came(const Reads& pins) {
      if (!pins.pready) return {};
      return Result{pins.prdata};
    }
  };

  static constexpr auto in() { return stream<Access, Master>("access"); }
  static constexpr auto out() { return stream<Result, Reader>("result"); }
  static constexpr auto pins() { return std::array{pin::reset_low("presetn")}; }

  static std::vector<Result> run(const std::vector<Access>& accesses) {
    Array<UInt<32>, 4> held = 0;  // two registers, their sum, and the number of accesses
    std::vector<Result> results;
    for (const Access& access : accesses) {
      held[2] = held[0] + held[1];
      results.push_back({held[access.reg]});
      if (access.write && access.reg < 2) held[access.reg] = access.data;
      ++held[3];
    }
    return results;
  }
};
