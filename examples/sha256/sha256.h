// The models of sha256.v: what comes out for what goes in, and what it does on every clock, a round
// of FIPS 180-4.
#pragma once

#include <cosim/stream.h>

#include "digest.h"

struct Sha256 {
  using Word = Hex<UInt<32>>;
  using Hash = Hex<UInt<256>>;
  struct In {
    Bit rst;                    // wait for a message
    Bit block_valid;            // there is a block
    Hex<UInt<512>> block_data;  // the block, its first word the highest
    Bit block_last;             // it is the last of its message
    Bit digest_ready;           // the digest is taken
  };
  struct Out {
    Bit block_ready;   // a block is taken
    Bit digest_valid;  // there is a digest
    Hash digest_data;  // the hash so far
  };
  static constexpr auto reset = active_high<&In::rst>;
  enum { IDLE, ROUNDS, ADD, DONE };

  UInt<2> phase = IDLE;
  Unreset<UInt<6>> round;                // t
  Unreset<Bit> last;                     // the message ends with this block
  Bit fresh = 1;                         // a message begins
  Unreset<Array<Word, 16>> w;            // W, of the rounds t to t + 15
  Unreset<Hash> hash;                    // H
  Unreset<Word> a, b, c, d, e, f, g, h;  // the working variables

  /// ROTR.
  static UInt<32> right(const UInt<32>& x, int n) { return x >> n | x << (32 - n); }

  static Hash joined(const sha256_model::Digest& words) {
    Hash all = 0;
    for (const std::uint32_t word : words) all = all << 32 | word;
    return all;
  }

  Out clock(const In& in) {
    const Out out{.block_ready = phase == IDLE, .digest_valid = phase == DONE, .digest_data = hash};
    if (in.rst) {
      phase = IDLE;
      fresh = 1;
    } else if (phase == IDLE) {
      if (in.block_valid) take(in);
    } else if (phase == ROUNDS) {
      if (round == 63) phase = ADD;
      one_round();
      ++round;
    } else if (phase == ADD) {
      const auto sum = [&](int i, const Word& x) { return UInt<32>(word(i) + x); };
      hash = cat(sum(0, a), sum(1, b), sum(2, c), sum(3, d), sum(4, e), sum(5, f), sum(6, g),
                 sum(7, h));
      phase = mux(last, DONE, IDLE);
    } else if (in.digest_ready) {
      phase = IDLE;
    }
    return out;
  }

  void take(const In& in) {
    if (fresh) hash = joined(sha256_model::start);
    a = word(0);
    b = word(1);
    c = word(2);
    d = word(3);
    e = word(4);
    f = word(5);
    g = word(6);
    h = word(7);
    for (int i = 0; i < 16; ++i) w[i] = in.block_data.bits<32>(32 * (15 - i));
    round = 0;
    last = in.block_last;
    fresh = in.block_last;
    phase = ROUNDS;
  }

  /// Word i of the hash, from the highest on.
  UInt<32> word(int i) const { return hash.bits<32>(32 * (7 - i)); }

  /// Of 6.2.2. W(t) is used and replaced by W(t + 16).
  void one_round() {
    const auto of = [&](int ahead) { return UInt<32>(w[UInt<4>(round + ahead)]); };
    const UInt<32> w0 = of(0), w1 = of(1), w14 = of(14);
    const UInt<32> s0 = right(w1, 7) ^ right(w1, 18) ^ w1 >> 3;
    const UInt<32> s1 = right(w14, 17) ^ right(w14, 19) ^ w14 >> 10;
    w[UInt<4>(round)] = w0 + s0 + of(9) + s1;

    static const Array<UInt<32>, 64> k = constants();
    const UInt<32> sum1 = right(e, 6) ^ right(e, 11) ^ right(e, 25);
    const UInt<32> sum0 = right(a, 2) ^ right(a, 13) ^ right(a, 22);
    const UInt<32> t1 = h + sum1 + ((e & f) ^ (~e & g)) + k[round] + w0;
    const UInt<32> t2 = sum0 + ((a & b) ^ (a & c) ^ (b & c));
    h = g;
    g = f;
    f = e;
    e = d + t1;
    d = c;
    c = b;
    b = a;
    a = t1 + t2;
  }

  static Array<UInt<32>, 64> constants() {
    Array<UInt<32>, 64> all = 0;
    for (int i = 0; i < 64; ++i) all[i] = sha256_model::constants[i];
    return all;
  }

  struct Block {
    Hex<UInt<512>> data;  // a block of the message
    Bit last;             // the message ends
  };
  struct Digest {
    Hash data;  // of the whole message
  };
  static constexpr auto in() { return stream<Block>("block"); }
  static constexpr auto out() { return stream<Digest>("digest").latency(66).steady(); }
  static constexpr auto pins() { return std::array{pin::reset("rst")}; }

  // A template, for it makes numbers of C++ of its fields: it is none of what is exported.
  static std::vector<Digest> run(const auto& blocks) {
    std::vector<Digest> digests;
    sha256_model::Digest hash = sha256_model::start;
    for (const auto& block : blocks) {
      sha256_model::Words m{};
      int low = 512;
      for (std::uint32_t& word : m) word = static_cast<std::uint32_t>(block.data >> (low -= 32));
      hash = sha256_model::hashed(hash, m);
      if (!block.last) continue;
      digests.push_back({joined(hash)});
      hash = sha256_model::start;
    }
    return digests;
  }
};
