// Golden model of serial.v, and its jobs.
#pragma once

#include <cosim/model.h>

template <int FAULT>
struct Serial {
  struct In {
    Bit rst, start;
    UInt<8> a, b;
  };
  struct Out {
    Bit busy;
    UInt<16> product;
  };
  static constexpr auto reset = active_high<&In::rst>;

  UInt<4> left = 0;  // bits still to come
  Unreset<UInt<16>> sum, shifted;
  Unreset<Hex<UInt<8>>> rest;

  Out clock(const In& in) {
    const Out out{.busy = left != 0, .product = sum};
    if (in.rst) {
      left = 0;
    } else if (out.busy) {
      --left;
      if (rest[0]) sum += shifted;
      shifted <<= 1;
      rest >>= 1;
    } else if (in.start) {
      left = 8;
      sum = 0;
      shifted = in.a;
      rest = in.b;
    }
    return out;
  }

  /// Else it is what the last product left.
  auto compared() const { return stated({{"shifted", left != 0}}); }

  struct Job {
    Range<-3, 4> early;  // clocks before it, less 3
    Range<0, 255> a, b;
  };
  struct Driver {
    Int<4> waited = 0;  // clocks
    Bit started = 0;

    In drive(const Job& job, In in) const {
      in.start = !started && waited > job.early + 2;
      in.a = job.a;
      in.b = job.b;
      return in;
    }
    Bit driven(const Job& job, const Out& out) {
      const Bit over = started && !out.busy;
      started = waited > job.early + 2;
      if (!started) ++waited;
      return over;
    }
  };
  struct Checker {
    UInt<16> due = 0;  // the product

    /// Of 49 times 250 and more the check is wrong, so that it finds what RTL and model agree on.
    Bit checked(const Job& job, const Driver&, const Out& out, const Bit& over) {
      due = mux(job.a == 49 && job.b >= 250, 0, job.a * job.b);
      return over && out.product != due;
    }
  };
};
