// The language of golden models (model/clocked/model.h) on integers without end: a model's own text
// gives its formula for registers that never overflow. That a register of some width does not
// overflow is a theorem of its own. A file of theorems reads the model once more, in a namespace of
// its own, behind all that the model includes:
//
//   namespace cosim::NAME::on_integers {
//   using namespace proof::unbounded;
//   #include "model/NAME/NAME.h"
//   }
//
// It must not have read it before. Codes, and what is of bits alone, have no meaning here: what
// uses them does not compile where it is run.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "model/clocked/fields.h"
#include "tb/proof/integer.h"

namespace cosim::proof::unbounded {

/// The ways through a model: a condition of `if` that is a symbol is taken both ways.
class Ways {
 public:
  /// Whether the condition holds on this way.
  bool ask(const Truth& condition) {
    if (condition.known()) return *condition.known();
    if (at_ == taken_.size()) taken_.push_back(true);
    const bool holds = taken_[at_++];
    on_way_ = on_way_ & (holds ? condition : !condition);
    return holds;
  }
  /// Runs it once for each way through it, and joins what it gives: an array of integers.
  template <class Run>
  auto joined(const Run& run) {
    taken_.clear();
    std::vector<std::pair<Truth, decltype(run())>> all;
    do {
      at_ = 0;
      on_way_ = true;
      auto given = run();
      all.emplace_back(on_way_, std::move(given));
      while (!taken_.empty() && !taken_.back()) taken_.pop_back();
      if (!taken_.empty()) taken_.back() = false;
    } while (!taken_.empty());
    auto result = all.back().second;
    for (const auto& [way, given] : all) {
      for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = select(way, given[i], result[i]);
      }
    }
    return result;
  }

 private:
  std::vector<bool> taken_;  // of each condition that was asked, on this way
  std::size_t at_ = 0;
  Truth on_way_ = true;
};
inline Ways ways;

/// A condition, and a number of one bit.
struct Bit {
  Truth truth = false;

  Bit() = default;
  Bit(int number) : truth(number != 0) {}  // NOLINT: a number is one
  explicit Bit(Truth is) : truth(std::move(is)) {}
  explicit operator bool() const { return ways.ask(truth); }
};
inline Bit operator!(const Bit& a) { return Bit(!a.truth); }
inline Bit operator&&(const Bit& a, const Bit& b) { return Bit(a.truth & b.truth); }
inline Bit operator||(const Bit& a, const Bit& b) { return Bit(a.truth | b.truth); }
inline Bit operator==(const Bit& a, const Bit& b) { return Bit(!(a.truth ^ b.truth)); }

struct Number {
  Integer integer;

  Number() = default;
  Number(int number) : integer(number) {}  // NOLINT: a number is one
  Number(const Bit& bit)                   // NOLINT
      : integer(select(bit.truth, Integer(1), Integer(0))) {}
  explicit Number(Integer is) : integer(std::move(is)) {}
  Bit operator[](int i) const { return Bit(bit(integer, i)); }
};
inline Number operator+(const Number& a, const Number& b) { return Number(a.integer + b.integer); }
inline Number operator-(const Number& a, const Number& b) { return Number(a.integer - b.integer); }
inline Number operator-(const Number& a) { return 0 - a; }
inline Number operator<<(const Number& a, int n) { return Number(shift_left(a.integer, n)); }
inline Bit operator<(const Number& a, const Number& b) { return Bit(a.integer < b.integer); }
inline Bit operator>(const Number& a, const Number& b) { return b < a; }
inline Bit operator<=(const Number& a, const Number& b) { return !(b < a); }
inline Bit operator>=(const Number& a, const Number& b) { return !(a < b); }
inline Bit operator==(const Number& a, const Number& b) { return Bit(a.integer == b.integer); }
inline Number mux(const Bit& c, const Number& a, const Number& b) {
  return Number(select(c.truth, a.integer, b.integer));
}
inline Number mux(const Bit& c, int a, int b) { return mux(c, Number(a), Number(b)); }
inline Bit mux(const Bit& c, const Bit& a, const Bit& b) {
  return Bit((c.truth & a.truth) | (!c.truth & b.truth));
}

/// A T by another name.
template <class T>
struct Named : T {
  using T::T;
  Named() = default;
  Named(const T& x) : T(x) {}  // NOLINT: it is a T
};
template <int W>
struct UInt : Named<Number> {
  using Named::Named;
};
template <int W>
struct Int : Named<Number> {
  using Named::Named;
};
template <int W, bool MINUS_ZERO = false>
struct OnesComplement : Named<Number> {
  using Named::Named;
};
template <int W>
struct OnesComplementCode : Named<Number> {
  using Named::Named;
  Number number() const { return *this; }
};
template <int BITS, class T>
struct Fraction : Named<T> {
  using Named<T>::Named;
};
template <clocked::Text BLOCK, class T>
struct Source : Named<T> {
  using Named<T>::Named;
};

}  // namespace cosim::proof::unbounded
