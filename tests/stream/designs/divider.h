// Start and done in place of ready and valid, and a rule of what may go in.
#pragma once

#include <cosim/stream.h>

template <int FAULT>
struct Divider {
  struct Asked {
    UInt<8> dividend;  // what
    UInt<8> divisor;   // by what
  };
  struct Given {
    UInt<8> quotient;   // how many times
    UInt<8> remainder;  // what is left
  };
  static constexpr auto in() {
    return stream<Asked>("asked").prefix("").valid("start").until("done");
  }
  static constexpr auto out() {
    return stream<Given>("given").prefix("").valid("done").rising().latency(10).steady();
  }
  static constexpr auto pins() { return std::array{pin::reset("rst")}; }
  static auto legal(const Asked& asked) {
    return stated({{"the divisor is not 0", asked.divisor != 0}});
  }
  static std::vector<Given> run(const std::vector<Asked>& asked) {
    std::vector<Given> given;
    for (const Asked& a : asked) given.push_back({a.dividend / a.divisor, a.dividend % a.divisor});
    return given;
  }
};
