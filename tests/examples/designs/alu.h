// Golden model of alu.v: a function of the inputs.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Alu {
  struct In {
    UInt<8> a, b;
    UInt<2> operation;  // add, subtract, and, exclusive or
  };
  struct Out {
    UInt<8> result;
    Bit zero;   // the result is 0
    Bit carry;  // out of the highest bit, or borrowed
  };

  Out clock(const In& in) const {
    Out out{.result = in.a ^ in.b, .zero = 0, .carry = 0};
    if (in.operation == 0) {
      const UInt<9> sum = in.a + in.b;
      out.result = sum;
      out.carry = sum[8];
    } else if (in.operation == 1) {
      out.result = in.a - in.b;
      out.carry = in.a < in.b;
    } else if (in.operation == 2) {
      out.result = in.a & in.b;
    }
    out.zero = out.result == 0;
    return out;
  }
};
