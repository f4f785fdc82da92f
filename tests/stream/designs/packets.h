// Packets: a `last` among the fields, ports by another prefix, one result for many transactions.
#pragma once

#include "../../support/fault.h"
#include "model/core/stream.h"

namespace packets_model {

using namespace cosim;
using faulty::Params;

#define PACKETS_BYTE(FIELD)          \
  FIELD(data, 8, bits, "", "a byte") \
  FIELD(last, 1, flag, "", "the packet ends")
#define PACKETS_SUM(FIELD)                   \
  FIELD(parity, 8, bits, "", "of all bytes") \
  FIELD(length, 8, number, "", "modulo 256")
COSIM_RECORD(Byte, PACKETS_BYTE, Params);
COSIM_RECORD(Sum, PACKETS_SUM, Params);

struct Design : faulty::Design {
  static constexpr const char* name = "packets";
  static constexpr auto in(const Params&) { return stream<Byte>("s").prefix("s_axis_t"); }
  static constexpr auto out(const Params&) { return stream<Sum>("sum").always_ready().latency(1); }
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }
  static std::vector<Sum<Word>> run(const Params&, const std::vector<Byte<Word>>& bytes) {
    std::vector<Sum<Word>> sums;
    Sum<Word> sum;
    for (const auto& byte : bytes) {
      sum = {sum.parity ^ byte.data, low_bits(sum.length + 1, 8)};
      if (byte.last == 0) continue;
      sums.push_back(sum);
      sum = {};
    }
    return sums;
  }
};

}  // namespace packets_model
