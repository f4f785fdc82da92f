// Two streams in and two out, wide fields, pins that belong to no stream.
#pragma once

#include "../../support/fault.h"
#include "model/core/stream.h"

namespace pairs_model {

using namespace cosim;
using faulty::Params;

#define PAIRS_A(FIELD)              \
  FIELD(number, 8, number, "", "a") \
  FIELD(swap, 1, flag.at("mode"), "", "in the other order")
#define PAIRS_B(FIELD) FIELD(number, 8, number, "", "b")
#define PAIRS_SUM(FIELD) FIELD(total, 9, number, "", "a + b")
#define PAIRS_PARTS(FIELD) FIELD(both, 100, bits.words<2>(), "", "one at each end")
COSIM_RECORD(A, PAIRS_A, Params);
COSIM_RECORD(B, PAIRS_B, Params);
COSIM_RECORD(Sum, PAIRS_SUM, Params);
COSIM_RECORD(Parts, PAIRS_PARTS, Params);

struct Design : faulty::Design {
  static constexpr const char* name = "pairs";
  static constexpr auto in(const Params&) {
    return std::tuple{stream<A>("a"), stream<B>("b").valid("b_vld").ready("b_rdy")};
  }
  static constexpr auto out(const Params&) {
    return std::tuple{stream<Sum>("sum").latency(1).steady(), stream<Parts>("parts").steady()};
  }
  static constexpr auto pins(const Params&) {
    return std::array{pin::reset_low("rst_n"), pin::tied("test_mode", 9, 4), pin::unread("busy")};
  }
  static auto run(const Params&, const std::vector<A<Word>>& a, const std::vector<B<Word>>& b) {
    std::vector<Sum<Word>> sums;
    std::vector<Parts<Word>> parts;
    for (std::size_t n = 0; n < a.size() && n < b.size(); ++n) {
      sums.push_back({a[n].number + b[n].number});
      const Word high = a[n].swap != 0 ? b[n].number : a[n].number;
      const Word low = a[n].swap != 0 ? a[n].number : b[n].number;
      parts.push_back({{low, high << 28}});
    }
    return std::tuple{sums, parts};
  }
};

}  // namespace pairs_model
