// Packets: a `last` among the fields, ports by another prefix, one result for many transactions.
#pragma once

#include <cosim/stream.h>

template <int FAULT>
struct Packets {
  struct Byte {
    Hex<UInt<8>> data;  // a byte
    Bit last;           // the packet ends
  };
  struct Sum {
    Hex<UInt<8>> parity = 0;  // of all bytes
    UInt<8> length = 0;       // modulo 256
  };
  static constexpr auto in() { return stream<Byte>("s").prefix("s_axis_t"); }
  static constexpr auto out() { return stream<Sum>("sum").always_ready().latency(1); }
  static constexpr auto pins() { return std::array{pin::reset("rst")}; }
  static std::vector<Sum> run(const std::vector<Byte>& bytes) {
    std::vector<Sum> sums;
    Sum sum;
    for (const Byte& byte : bytes) {
      sum = {sum.parity ^ byte.data, sum.length + 1};
      if (!byte.last) continue;
      sums.push_back(sum);
      sum = {};
    }
    return sums;
  }
};
