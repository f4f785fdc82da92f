// What comes out of the hash of examples/sha256, and nothing of its clocks.
#pragma once

#include <cosim/stream.h>

#include "../../../examples/sha256/sha256.h"

struct Word {
  static constexpr auto in() { return Sha256::in(); }
  static constexpr auto out() { return Sha256::out(); }
  static constexpr auto pins() { return Sha256::pins(); }
  static auto run(const std::vector<Sha256::Block>& blocks) { return Sha256::run(blocks); }
};
