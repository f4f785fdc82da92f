// A wire wider than a word: a block of 100 bits, which a driver gives in words.
#pragma once

#include "../../support/fault.h"
#include "model/core/stream.h"

namespace blocks_model {

using namespace cosim;
using faulty::Params;

#define BLOCKS_BLOCK(FIELD)                     \
  FIELD(low, 64, bits, "", "its lower 64 bits") \
  FIELD(high, 36, bits, "", "its upper 36 bits")
COSIM_RECORD(Block, BLOCKS_BLOCK, Params);
#define BLOCKS_DIGEST(FIELD) FIELD(digest, 50, bits.at("digest"), "", "both halves")
COSIM_RECORD(Digest, BLOCKS_DIGEST, Params);

class Giver {
 public:
  static constexpr auto drives(const Params&) {
    return std::array{pin::wire("block", 100), pin::wire("go")};
  }
  static constexpr auto reads(const Params&) { return std::array{pin::wire("seen", 70)}; }

  void drive(const Block<Word>* block, std::span<Word> pins) {
    pins[2] = block != nullptr;
    pins[0] = block != nullptr ? block->low : -1;
    pins[1] = block != nullptr ? block->high : 0;
  }
  bool took(std::span<const Word> pins) { return pins.size() == 2; }
};

struct Design : faulty::Design {
  static constexpr const char* name = "blocks";
  static constexpr auto in(const Params&) { return stream<Block>("in").by<Giver>(); }
  static constexpr auto out(const Params&) { return stream<Digest>("digest").always_ready(); }
  static constexpr auto pins(const Params&) {
    return std::array{pin::reset("rst"), pin::tied("key", Word{1} << 63, 70)};
  }
  static std::vector<Digest<Word>> run(const Params&, const std::vector<Block<Word>>& in) {
    std::vector<Digest<Word>> out;
    for (const Block<Word>& block : in) {
      const Word upper = low_bits(block.low >> 50, 14) + (block.high << 14);
      out.push_back({upper ^ low_bits(block.low, 50) ^ (Word{1} << 43)});
    }
    return out;
  }
};

}  // namespace blocks_model
