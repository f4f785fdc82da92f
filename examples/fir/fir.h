// What comes out of fir.v for what goes in.
#pragma once

#include <cosim/stream.h>

/// W: bits of a sample. STAGES: of the pipeline.
template <int W, int STAGES>
struct Fir {
  struct X {
    Int<W> data;  // a sample
  };
  struct Y {
    Int<W + 5> data;  // the filtered sample
  };
  static constexpr auto in() { return stream<X>("x"); }
  static constexpr auto out() { return stream<Y>("y").latency(STAGES); }
  static constexpr auto pins() { return std::array{pin::reset("rst")}; }

  static std::vector<Y> run(const std::vector<X>& x) {
    const auto at = [&](std::size_t n, std::size_t back) {
      return n < back ? Int<W>(0) : x[n - back].data;
    };
    std::vector<Y> y;
    for (std::size_t n = 0; n < x.size(); ++n) {
      y.push_back({9 * at(n, 2) + 5 * (at(n, 1) + at(n, 3)) - (at(n, 0) + at(n, 4))});
    }
    return y;
  }
};
