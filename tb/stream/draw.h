// Random cases of a design with a stream model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "tb/sim/stimulus.h"
#include "tb/stream/shape.h"

namespace cosim {

/// Whether a transaction may go into stream s; empty: each may.
using MayGo = std::function<bool(std::size_t s, std::span<const Word> words)>;

/// Case number `index` under the seed: a few transactions or up to `most`, of random values with
/// their corners. A case has no stalls at all, or random ones of a density of its own for each
/// interface, or one interface that starves all others, or long stretches with and without. In one
/// of four, who takes is ready only where valid was seen, always or now and then.
/// InputError where no transaction that may go is found.
Stimulus draw_stream_case(const StreamShape& shape, std::uint64_t seed, std::uint64_t index,
                          std::uint64_t most, const MayGo& may_go);

/// The same case, taken apart into `into`, whose memory it uses again. Gives its power-up.
std::uint32_t draw_stream_case(const StreamShape& shape, std::uint64_t seed, std::uint64_t index,
                               std::uint64_t most, const MayGo& may_go, StreamCase& into);

/// A case of these transactions, some of each stream that goes in, with random stalls.
Stimulus stalled(const StreamShape& shape, std::uint64_t seed, const std::vector<Sequence>& given);

}  // namespace cosim
