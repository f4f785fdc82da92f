// The models of sha256.v: what comes out for what goes in, and what it does on every clock.
#pragma once

#include <cstdint>

#include "clocks.h"
#include "digest.h"
#include "model/core/stream.h"

namespace sha256_model {

using namespace cosim;

struct Params {};

#define SHA256_BLOCK(FIELD)                                       \
  FIELD(data, 512, bits.words<8>(), "", "a block of the message") \
  FIELD(last, 1, flag, "", "the message ends")
#define SHA256_DIGEST(FIELD) FIELD(data, 256, bits.words<4>(), "", "of the whole message")
COSIM_RECORD(Block, SHA256_BLOCK, Params);
COSIM_RECORD(Hash, SHA256_DIGEST, Params);

struct Design {
  using Params = sha256_model::Params;
  static constexpr const char* name = "sha256";
  static constexpr auto in(const Params&) { return stream<Block>("block"); }
  static constexpr auto out(const Params&) { return stream<Hash>("digest").latency(66).steady(); }
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }

  static std::vector<Hash<Word>> run(const Params&, const std::vector<Block<Word>>& blocks) {
    std::vector<Hash<Word>> digests;
    Digest hash = start;
    for (const Block<Word>& in : blocks) {
      Words m{};
      for (int i = 0; i < 16; ++i) {  // the words of 64 bits begin with the lowest
        m[static_cast<std::size_t>(i)] =
            static_cast<std::uint32_t>(shift_right(in.data[7 - i / 2], i % 2 == 0 ? 32 : 0));
      }
      hash = hashed(hash, m);
      if (in.last == 0) continue;
      Hash<Word> out;
      for (int i = 0; i < 8; ++i) {
        out.data[3 - i / 2] |= shift_left(hash[static_cast<std::size_t>(i)], i % 2 == 0 ? 32 : 0);
      }
      digests.push_back(out);
      hash = start;
    }
    return digests;
  }
};

}  // namespace sha256_model
