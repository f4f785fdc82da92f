// Integers without a bound, as slow and as simple as can be: what values are compared with.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cosim::clocked::test {

/// A sign and digits of 16 bits, the lowest first, none of them 0 at the top.
class Big {
 public:
  Big(long long v) : minus_(v < 0) {  // NOLINT
    for (unsigned long long u = v < 0 ? 0ull - static_cast<unsigned long long>(v)
                                      : static_cast<unsigned long long>(v);
         u != 0; u >>= 16)
      d_.push_back(u & 0xffff);
  }
  static Big power(int n) {  // 2^n
    Big r(1);
    r.d_.insert(r.d_.begin(), static_cast<std::size_t>(n / 16), 0);
    r.d_.back() <<= n % 16;
    return r;
  }
  friend Big operator-(Big a) {
    a.minus_ = !a.minus_ && !a.d_.empty();
    return a;
  }
  friend Big operator+(const Big& a, const Big& b) {
    if (a.minus_ != b.minus_) return a - -b;
    Big r(0);
    std::uint32_t carry = 0;
    for (std::size_t i = 0; i < a.d_.size() || i < b.d_.size() || carry != 0; ++i) {
      carry += a.digit(i) + b.digit(i);
      r.d_.push_back(carry & 0xffff);
      carry >>= 16;
    }
    r.minus_ = a.minus_ && !r.d_.empty();
    return r;
  }
  friend Big operator-(const Big& a, const Big& b) {
    if (b.d_.empty()) return a;
    if (a.minus_ != b.minus_) return a + -b;
    if (smaller(a, b)) return -(b - a);
    Big r(0);
    std::int32_t borrow = 0;
    for (std::size_t i = 0; i < a.d_.size(); ++i) {
      const std::int32_t x =
          static_cast<std::int32_t>(a.digit(i)) - static_cast<std::int32_t>(b.digit(i)) - borrow;
      borrow = x < 0;
      r.d_.push_back(static_cast<std::uint32_t>(x + (borrow << 16)));
    }
    r.minus_ = a.minus_;
    return r.trimmed();
  }
  friend Big operator*(const Big& a, const Big& b) {
    Big r(0);
    for (std::size_t i = b.d_.size(); i-- > 0;) {
      r.d_.insert(r.d_.begin(), 0);
      std::uint64_t carry = 0;
      Big part(0);
      for (std::size_t j = 0; j < a.d_.size() || carry != 0; ++j) {
        carry += std::uint64_t{a.digit(j)} * b.d_[i];
        part.d_.push_back(carry & 0xffff);
        carry >>= 16;
      }
      r = r.trimmed() + part.trimmed();
    }
    r.minus_ = a.minus_ != b.minus_ && !r.d_.empty();
    return r;
  }
  /// Rounded to 0; b is not 0.
  friend Big operator/(const Big& a, const Big& b) { return a.divided(b, false); }
  friend Big operator%(const Big& a, const Big& b) { return a.divided(b, true); }
  friend bool operator<(const Big& a, const Big& b) {
    if (a.minus_ != b.minus_) return a.minus_;
    return a.minus_ ? smaller(b, a) : smaller(a, b);
  }
  friend bool operator==(const Big&, const Big&) = default;
  /// a modulo 2^n, 0 or more.
  Big low(int n) const {
    const Big r = *this % power(n);
    return r.minus_ ? r + power(n) : r;
  }
  /// As a number of n bits with a sign.
  Big with_sign(int n) const {
    const Big r = low(n);
    return r < power(n - 1) ? r : r - power(n);
  }
  friend Big operator<<(const Big& a, int n) { return a * power(n); }
  friend Big operator>>(const Big& a, int n) { return (a - a.low(n)) / power(n); }
  friend Big operator&(const Big& a, const Big& b) { return a.bitwise(b, 8); }
  friend Big operator|(const Big& a, const Big& b) { return a.bitwise(b, 14); }
  friend Big operator^(const Big& a, const Big& b) { return a.bitwise(b, 6); }
  bool bit(int i) const { return !((*this >> i).low(1) == Big(0)); }
  std::uint32_t digit(std::size_t i) const { return i < d_.size() ? d_[i] : 0; }
  bool is_minus() const { return minus_; }

 private:
  static bool smaller(const Big& a, const Big& b) {
    if (a.d_.size() != b.d_.size()) return a.d_.size() < b.d_.size();
    for (std::size_t i = a.d_.size(); i-- > 0;) {
      if (a.d_[i] != b.d_[i]) return a.d_[i] < b.d_[i];
    }
    return false;
  }
  Big& trimmed() {
    while (!d_.empty() && d_.back() == 0) d_.pop_back();
    if (d_.empty()) minus_ = false;
    return *this;
  }
  Big divided(const Big& b, bool rest) const {
    Big q(0), r(0);
    q.d_.resize(d_.size());
    Big m = b;
    m.minus_ = false;
    for (std::size_t i = 16 * d_.size(); i-- > 0;) {
      r = r + r;
      if (d_[i / 16] >> i % 16 & 1) r = r + Big(1);
      if (smaller(r, m)) continue;
      r = r - m;
      q.d_[i / 16] |= 1u << i % 16;
    }
    Big& result = rest ? r : q.trimmed();
    result.minus_ = (rest ? minus_ : minus_ != b.minus_) && !result.d_.empty();
    return result;
  }
  // Bit by bit of numbers with a sign.
  Big bitwise(const Big& b, int table) const {
    const std::size_t n = std::max(d_.size(), b.d_.size()) + 1;
    const Big x = low(static_cast<int>(16 * n)), y = b.low(static_cast<int>(16 * n));
    Big r(0);
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t p = x.digit(i), q = y.digit(i);
      r.d_.push_back(table == 8 ? p & q : table == 14 ? p | q : p ^ q);
    }
    return r.trimmed().with_sign(static_cast<int>(16 * n));
  }

  bool minus_;
  std::vector<std::uint32_t> d_;
};

}  // namespace cosim::clocked::test
