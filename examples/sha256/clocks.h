// What sha256.v does on every clock. The function itself is in FIPS 180-4, as in digest.h, but for
// values of any type, and one round at a time.
#pragma once

#include "digest.h"
#include "model/core/bit_strings.h"
#include "model/core/design.h"
#include "model/core/memory.h"

namespace sha256_model {

using namespace cosim;

struct Params {};

#define SHA256_INPUTS(FIELD)                                                           \
  FIELD(rst, 1, flag, "", "wait for a message")                                        \
  FIELD(block_valid, 1, flag, "", "there is a block")                                  \
  FIELD(block_data, 512, bits.words<8>(), "", "the block, its first word the highest") \
  FIELD(block_last, 1, flag, "", "it is the last of its message")                      \
  FIELD(digest_ready, 1, flag, "", "the digest is taken")
#define SHA256_OUTPUTS(FIELD)                           \
  FIELD(block_ready, 1, flag, "", "a block is taken")   \
  FIELD(digest_valid, 1, flag, "", "there is a digest") \
  FIELD(digest_data, 256, bits.words<4>(), "", "the hash so far")
#define SHA256_STATE(FIELD)                                                    \
  FIELD(phase, 2, number, "", "idle, rounds, add, done")                       \
  FIELD(round, 6, number.unreset(), "", "t")                                   \
  FIELD(last, 1, flag.unreset(), "", "the message ends with this block")       \
  FIELD(fresh, 1, flag, "", "a message begins")                                \
  FIELD(w, 32, bits.array<16>().unreset(), "", "W, of the rounds t to t + 15") \
  FIELD(hash, 256, bits.words<4>().unreset(), "", "H")                         \
  FIELD(a, 32, bits.unreset(), "", "the working variables")                    \
  FIELD(b, 32, bits.unreset(), "", "")                                         \
  FIELD(c, 32, bits.unreset(), "", "")                                         \
  FIELD(d, 32, bits.unreset(), "", "")                                         \
  FIELD(e, 32, bits.unreset(), "", "")                                         \
  FIELD(f, 32, bits.unreset(), "", "")                                         \
  FIELD(g, 32, bits.unreset(), "", "")                                         \
  FIELD(h, 32, bits.unreset(), "", "")
COSIM_RECORDS(SHA256, Params);

namespace clocks {

inline constexpr int idle = 0, rounds = 1, add = 2, done = 3;

/// ROTR.
template <class V>
constexpr V right(V x, int n) {
  return rotate_left(x, 32 - n, 32);
}

/// Word i, from the highest on, of a number of N words of 64 bits.
template <class V, int N>
constexpr V word(const Array<V, N>& number, int i) {
  const V both = number[N - 1 - i / 2];
  return i % 2 == 0 ? slice(both, 63, 32) : low_bits(both, 32);
}

/// Modulo 2^32, from the first on, as the standard has the sums.
template <class V, class... More>
constexpr V sum(V a, V b, More... more) {
  const V both = wrap(a + b, 32);
  if constexpr (sizeof...(more) == 0) {
    return both;
  } else {
    return sum(both, more...);
  }
}

template <class V>
constexpr V constant(V t) {
  Array<V, 64> all;
  for (int i = 0; i < 64; ++i) all[i] = V(constants[i]);
  return read(all, t);
}

template <class V>
constexpr Array<V, 8> working(const State<V>& s) {
  return {s.a, s.b, s.c, s.d, s.e, s.f, s.g, s.h};
}

/// A state whose working variables are `x` where `now` holds.
template <class V>
constexpr void put(State<V>& s, Condition<V> now, const Array<V, 8>& x) {
  V* const all[8] = {&s.a, &s.b, &s.c, &s.d, &s.e, &s.f, &s.g, &s.h};
  for (int i = 0; i < 8; ++i) *all[i] = select(now, x[i], *all[i]);
}

/// One round of 6.2.2.
template <class V>
constexpr Array<V, 8> round(const State<V>& s, V k, V w) {
  const V sum1 = right(s.e, 6) ^ right(s.e, 11) ^ right(s.e, 25);
  const V sum0 = right(s.a, 2) ^ right(s.a, 13) ^ right(s.a, 22);
  const V t1 = sum(s.h, sum1, (s.e & s.f) ^ (invert(s.e, 32) & s.g), k, w);
  const V t2 = sum(sum0, (s.a & s.b) ^ (s.a & s.c) ^ (s.b & s.c));
  return {sum(t1, t2), s.a, s.b, s.c, sum(s.d, t1), s.e, s.f, s.g};
}

}  // namespace clocks

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  using namespace clocks;
  const auto is = [&](int phase) { return s.phase == V(phase); };
  const auto begins = is(idle) & is_set(in.block_valid), fresh = is_set(s.fresh);
  Step<V> step{s, {flag<V>(is(idle)), flag<V>(is(done)), s.hash}};
  State<V>& after = step.state;

  // A block is taken.
  Array<V, 8> from;
  Array<V, 4> first;
  for (int i = 0; i < 8; ++i) {
    const V h0 = V(start[static_cast<std::size_t>(i)]);
    from[i] = select(fresh, h0, word(s.hash, i));
    first[3 - i / 2] = i % 2 == 0 ? h0 : join(first[3 - i / 2], h0, 32);
  }
  put(after, begins, from);
  after.hash = select(begins & fresh, first, after.hash);
  for (int i = 0; i < 16; ++i) after.w[i] = select(begins, word(in.block_data, i), after.w[i]);
  after.round = select(begins, V(0), after.round);
  after.last = select(begins, in.block_last, after.last);
  after.fresh = select(begins, in.block_last, after.fresh);

  // W(t) is replaced by W(t + 16), and is used.
  const auto of = [&](int ahead) { return read(s.w, wrap(s.round + V(ahead), 4)); };
  const V w1 = of(1), w14 = of(14);
  const V s0 = right(w1, 7) ^ right(w1, 18) ^ shift_right(w1, 3);
  const V s1 = right(w14, 17) ^ right(w14, 19) ^ shift_right(w14, 10);
  const V ahead = sum(of(0), s0, of(9), s1);
  after.w = write_where(is(rounds), after.w, wrap(s.round, 4), ahead);
  put(after, is(rounds), clocks::round(s, constant(s.round), of(0)));
  after.round = select(is(rounds), wrap(s.round + V(1), 6), after.round);

  // The sum with what was before the block.
  const Array<V, 8> x = working(s);
  Array<V, 4> hash;
  for (int i = 0; i < 8; ++i) {
    const V one = sum(word(s.hash, i), x[i]);
    hash[3 - i / 2] = i % 2 == 0 ? one : join(hash[3 - i / 2], one, 32);
  }
  after.hash = select(is(clocks::add), hash, after.hash);

  after.phase =
      select(begins, V(rounds),
             select(is(rounds) & (s.round == V(63)), V(clocks::add),
                    select(is(clocks::add), select(is_set(s.last), V(done), V(idle)),
                           select(is(done) & is_set(in.digest_ready), V(idle), s.phase))));
  const auto reset = is_set(in.rst);
  State<V> cleared = s;
  cleared.phase = V(idle);
  cleared.fresh = V(1);
  step.state = select(reset, cleared, after);
  return step;
}

}  // namespace sha256_model
