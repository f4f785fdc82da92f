// Expressions at every width, beside big integers and beside what the exporter wrote of them.
#include "tests/clocked/expressions.h"

#include "tests/clocked/big.h"
#include "tests/clocked/compare.h"

namespace cosim::clocked::test {
namespace {

template <Value V>
Big to_big(const V& x) {
  const Wide words = resized<Wide, V::is_signed>(Inside::rep(Inside::base(x)));
  Big r(0);
  for (int i = (V::width + 31) / 32; i >= 0; --i) {
    r = (r << 32) + Big(static_cast<long long>(words[i / 2] >> i % 2 * 32 & 0xffffffff));
  }
  const int bits = 32 * ((V::width + 31) / 32 + 1);
  return V::is_signed ? r.with_sign(bits) : r;
}
template <class V>
Big all_ones() {
  return V::is_signed ? Big(-1) : Big::power(V::width) - Big(1);
}

// A value and the number that it must be; each operation is compared.
template <class V>
struct Both {
  V value;
  Big big;
};
template <class V>
Both<V> same(const V& value, const Big& big, const char* what) {
  EXPECT_TRUE(to_big(value) == big) << what << " of " << V::width << " bits";
  return {value, big};
}
#define COMPARED(OP)                                      \
  template <class A, class B>                             \
  auto operator OP(const Both<A>& a, const Both<B>& b) {  \
    return same(a.value OP b.value, a.big OP b.big, #OP); \
  }                                                       \
  template <class A>                                      \
  auto operator OP(const Both<A>& a, int b) {             \
    return same(a.value OP b, a.big OP Big(b), #OP);      \
  }
COMPARED(+)
COMPARED(-)
COMPARED(*)
COMPARED(&)
COMPARED(|)
COMPARED(^)
#undef COMPARED
template <class A, class B>
auto operator/(const Both<A>& a, const Both<B>& b) {
  using R = decltype(a.value / b.value);
  return same(a.value / b.value, b.big == Big(0) ? all_ones<R>() : a.big / b.big, "/");
}
template <class A, class B>
auto operator%(const Both<A>& a, const Both<B>& b) {
  return same(a.value % b.value, b.big == Big(0) ? a.big : a.big % b.big, "%");
}
template <class A>
auto operator-(int a, const Both<A>& b) {
  return same(a - b.value, Big(a) - b.big, "int -");
}
template <class A>
auto operator-(const Both<A>& a) {
  return same(-a.value, -a.big, "-");
}
template <class A>
auto operator<<(const Both<A>& a, int n) {
  return same(a.value << n, a.big << n, "<<");
}
template <class A>
auto operator>>(const Both<A>& a, int n) {
  return same(a.value >> n, a.big >> n, ">>");
}

template <class Model>
struct Widths;
template <int W, bool S, bool T, unsigned SEED>
struct Widths<Expressions<W, S, T, SEED>> {
  using M = Expressions<W, S, T, SEED>;
  static void check(Random& random) {
    auto in = zero<typename M::In>();
    std::vector<Wide> codes;
    draw(random, in, codes);
    const typename M::Out out = M{}.clock(in);
    const Both<typename M::A> a = same(in.a, to_big(in.a), "a");
    const Both<typename M::B> b = same(in.b, to_big(in.b), "b");
    const auto e = expression<SEED, 2>(a, b);
    const int n = static_cast<int>(in.n);
    const auto fitted = [](const Big& x) { return S ? x.with_sign(W) : x.low(W); };
    same(out.e, e.big, "e");
    same(out.kept, e.big.with_sign(W + 3), "kept");
    same(out.less, Big(e.big < b.big), "less");
    same(out.equal, Big(e.big == b.big), "equal");
    same(out.left, a.big << n, "left");
    same(out.right, a.big >> n, "right");
    same(out.bit, Big(n < W && a.big.bit(n)), "bit");
    Big written = a.big.low(W / 2) + (b.big.low(W - W / 2) << W / 2);
    if (n < W) written = written + Big(b.big.bit(0) - written.bit(n)) * Big::power(n);
    same(out.written, fitted(written), "written");
  }
};

TEST(ClockedExpressions, AreThoseOfBigIntegers) {
  Random random(7);
  for_each_width(
      [&]<class Model>(const std::string& name) {
        SCOPED_TRACE(name);
        for (int i = 0; i < 60; ++i) Widths<Model>::check(random);
      },
      AllWidths());
}

TEST(ClockedExpressions, AreWhatTheExporterWrote) {
  for_each_width([]<class Model>(const std::string& name) { compare<Model>(name, 60); },
                 AllWidths());
}

}  // namespace
}  // namespace cosim::clocked::test
