// What comes out of fir.v for what goes in.
#pragma once

#include "model/core/stream.h"

namespace fir_model {

using namespace cosim;

struct Params {
  int width, stages;
};

#define FIR_X(FIELD) FIELD(data, p.width, twos_complement, "", "a sample")
#define FIR_Y(FIELD) FIELD(data, p.width + 5, twos_complement, "", "the filtered sample")
COSIM_RECORD(X, FIR_X, Params);
COSIM_RECORD(Y, FIR_Y, Params);

struct Design {
  using Params = fir_model::Params;
  static constexpr const char* name = "fir";
  static constexpr auto parameters(const Params& p) {
    return std::array<Parameter, 2>{{{"W", p.width}, {"STAGES", p.stages}}};
  }
  static constexpr auto in(const Params&) { return stream<X>("x"); }
  static constexpr auto out(const Params& p) { return stream<Y>("y").latency(p.stages); }
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }

  static std::vector<Y<Word>> run(const Params&, const std::vector<X<Word>>& x) {
    const auto at = [&](std::size_t n, std::size_t back) {
      return n < back ? 0 : x[n - back].data;
    };
    std::vector<Y<Word>> y(x.size());
    for (std::size_t n = 0; n < x.size(); ++n) {
      y[n] = {9 * at(n, 2) + 5 * (at(n, 1) + at(n, 3)) - (at(n, 0) + at(n, 4))};
    }
    return y;
  }
};

}  // namespace fir_model
