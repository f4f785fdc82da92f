#include "tb/stream/draw.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/util/random.h"

namespace cosim {
namespace {

/// How often an interface stalls, and for how long.
struct Density {
  int rarity = never;      // one in 2^rarity
  std::uint64_t most = 0;  // clocks
  bool stretches = false;  // on and off for some transactions each
  int waiting = never;     // one in 2^waiting is not taken before its valid was seen

  static constexpr int never = 64;

  Word stall(Random& random, std::size_t row) const {
    if (rarity == never || (stretches && (row / 8) % 2 == 0)) return 0;
    return random.one_in_power(rarity) ? static_cast<Word>(1 + random.below(most)) : 0;
  }
  Word waits(Random& random) const {
    return waiting != never && random.one_in_power(waiting) ? 1 : 0;
  }
};

Density random_density(Random& random) {
  Density d;
  const std::uint64_t r = random.next();
  if (r % 4 == 0) return d;
  d.rarity = static_cast<int>((r >> 8) % 4);
  d.most = std::uint64_t{1} << ((r >> 16) % 5);
  d.stretches = (r >> 24) % 4 == 0;
  return d;
}

std::vector<Density> stalling(Random& random, std::size_t interfaces) {
  std::vector<Density> all(interfaces);
  const std::uint64_t kind = random.below(8);
  if (kind < 2) return all;  // no stalls
  if (kind < 4) {            // one starves the others
    Density& one = all[random.below(interfaces)];
    one.rarity = 0;
    one.most = 8 + random.below(24);
    return all;
  }
  if (kind == 4) {  // now and then one is shut for so long that whatever can fill up does
    Density& one = all[random.below(interfaces)];
    one.rarity = 3;
    one.most = (1 << stall_width) - 1;
    return all;
  }
  for (Density& d : all) d = random_density(random);
  return all;
}

// Whatever the stalls are, who takes may look for valid first: always, or now and then.
std::vector<Density> densities(Random& random, std::size_t interfaces) {
  std::vector<Density> all = stalling(random, interfaces);
  if (!random.one_in_power(2)) return all;
  const bool always = random.one_in_power(1);
  for (Density& d : all) d.waiting = always ? 0 : static_cast<int>(random.below(4));
  return all;
}

// At most `longest`, or a fourth of it, a sixteenth, a sixty-fourth.
std::uint64_t transactions(Random& random, std::uint64_t longest, std::uint64_t most) {
  const std::uint64_t size = longest >> (6 - 2 * random.below(4));
  return 1 + random.below(std::clamp<std::uint64_t>(size, 1, most));
}

Word any(Random& random, const Field& field) {
  if (field.named > 0) return static_cast<Word>(random.below(field.named));
  return random.corner(field.width);
}

Word value(Random& random, const Field& field, const CellDraw& draw) {
  if (draw.shares.empty()) return any(random, field);
  std::uint64_t at = random.below(draw.total);
  auto share = draw.shares.begin();
  for (; at >= share->weight; ++share) at -= share->weight;
  if (share->is_any) return any(random, field);
  const auto values =
      static_cast<std::uint64_t>(share->high) - static_cast<std::uint64_t>(share->low) + 1;
  const auto above = static_cast<std::int64_t>(random.below(values));
  return low_bits(static_cast<Word>(share->low + above), field.width);
}

void draw_transaction(Random& random, const StreamShape& shape, std::size_t s, const MayGo& may_go,
                      std::span<Word> words) {
  constexpr int tries = 1000;
  const Interface& in = shape.in[s];
  for (int i = 0; i < tries; ++i) {
    for (std::size_t c = 0; c < words.size(); ++c) {
      words[c] = value(random, in.cells[c], in.draws[c]);
    }
    if (in.arrange) in.arrange(words);
    if (!may_go || may_go(s, words)) return;
  }
  throw InputError(fmt::format("{}: of {} random transactions of stream {} none is legal",
                               shape.title, tries, in.name));
}

// Calls take(row) for each row, whose memory is used again; gives the power-up. The transactions
// are those of `given`, unless that is empty.
template <class Take>
std::uint32_t draw(const StreamShape& shape, std::uint64_t seed, std::uint64_t index,
                   std::uint64_t most, const MayGo& may_go, const std::vector<Sequence>& given,
                   const Take& take) {
  Random random = Random::for_case(seed, index);
  const auto power_up = static_cast<std::uint32_t>(random.next());
  std::uint64_t rows =
      transactions(random, shape.most_transactions, std::max<std::uint64_t>(most, 1));
  for (const Sequence& all : given) {
    rows = std::max<std::uint64_t>(&all == &given.front() ? 0 : rows, all.size());
  }
  const auto density = densities(random, shape.in.size() + shape.out.size());
  // Where two streams belong together, a transaction too few in one leaves the other waiting.
  const bool all_give = shape.in.size() == 1 || random.one_in_power(1);

  std::vector<Word> row(shape.columns().size());
  for (std::uint64_t n = 0; n < rows; ++n) {
    auto column = row.begin();
    std::size_t at = 0;
    for (std::size_t s = 0; s < shape.in.size(); ++s) {
      const bool gives = given.empty() ? all_give || !random.one_in_power(3) : n < given[s].size();
      *column++ = gives ? 1 : 0;
      const Word stall = density[at++].stall(random, n);
      *column++ = gives ? stall : 0;
      const std::span<Word> words(column, shape.in[s].cells.size());
      column += static_cast<std::ptrdiff_t>(words.size());
      if (given.empty()) draw_transaction(random, shape, s, may_go, words);
      if (!gives) std::fill(words.begin(), words.end(), 0);
      if (gives && !given.empty()) std::ranges::copy(given[s][n], words.begin());
    }
    for (const Interface& i : shape.out) {
      const Density& d = density[at++];
      const Word stall = d.stall(random, n);
      if (i.can_stall()) *column++ = stall;
      if (i.can_wait()) *column++ = d.waits(random);
    }
    take(row);
  }
  return power_up;
}

}  // namespace

Stimulus draw_stream_case(const StreamShape& shape, std::uint64_t seed, std::uint64_t index,
                          std::uint64_t most, const MayGo& may_go) {
  Stimulus stimulus;
  stimulus.machine = shape.title;
  stimulus.power_up = draw(shape, seed, index, most, may_go, {},
                           [&](const std::vector<Word>& row) { stimulus.clocks.push_back(row); });
  return stimulus;
}

std::uint32_t draw_stream_case(const StreamShape& shape, std::uint64_t seed, std::uint64_t index,
                               std::uint64_t most, const MayGo& may_go, StreamCase& into) {
  into.clear();
  return draw(shape, seed, index, most, may_go, {},
              [&](const std::vector<Word>& row) { into.add(shape, row); });
}

Stimulus stalled(const StreamShape& shape, std::uint64_t seed, const std::vector<Sequence>& given) {
  Stimulus stimulus;
  stimulus.machine = shape.title;
  stimulus.power_up = draw(shape, seed, 0, 1, {}, given,
                           [&](const std::vector<Word>& row) { stimulus.clocks.push_back(row); });
  return stimulus;
}

}  // namespace cosim
