// Wires wider than a word: a block of 100 bits, which a driver gives on one clock.
#pragma once

#include <cosim/stream.h>

template <int FAULT>
struct Blocks {
  struct Block {
    struct Halves {
      Hex<UInt<64>> low;
      Hex<UInt<36>> high;
    };
    Halves half;
  };
  struct Digest {
    At<"digest", Hex<UInt<50>>> digest;  // both halves
  };

  struct Giver {
    struct Drives {
      At<"block", UInt<100>> bits;
      Bit go;
    };
    struct Reads {
      UInt<70> seen;
    };
    UInt<100> given = 0;
    bool is_given = false;

    Drives drive(const Block* block) {
      if (block == nullptr) return {~UInt<64>(0), 0};
      const bool go = !is_given;
      is_given = true;
      given = cat(block->half.high, block->half.low);
      return {given, go};
    }
    /// A clock after go.
    bool took(const Reads& pins) {
      const bool taken = is_given && pins.seen == given >> 30;
      if (taken) is_given = false;
      return taken;
    }
  };

  static constexpr auto in() { return stream<Block, Giver>("in"); }
  static constexpr auto out() { return stream<Digest>("digest").always_ready(); }
  static constexpr auto pins() {
    return std::array{pin::reset("rst"), pin::tied("key", std::uint64_t{1} << 63, 70)};
  }
  static std::vector<Digest> run(const std::vector<Block>& in) {
    std::vector<Digest> out;
    for (const Block& block : in) {
      const UInt<100> all = cat(block.half.high, block.half.low);
      out.push_back(
          {all.template slice<99, 50>() ^ all.template slice<49, 0>() ^ UInt<50>(1) << 43});
    }
    return out;
  }
};
