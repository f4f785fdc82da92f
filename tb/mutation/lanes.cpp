// Parallel fault simulation: one fault in each lane of a word, all under the same inputs, each
// compared with the model. What does not depend on a fault of these lanes is folded once for all
// (constants, and gates alike). A fault of a clock's net becomes lanes in which a flip-flop takes
// the other edge, or none.
#include "tb/mutation/lanes.h"

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "model/core/input_error.h"
#include "tb/proof/located.h"
#include "tb/util/random.h"

namespace cosim::mutation {
namespace {

using nets::Bit;
using nets::Plane;

constexpr int mutsel_bits = 16;
constexpr std::uint32_t none = ~std::uint32_t{0};

}  // namespace

PlantedNets::PlantedNets(std::string title, const BenchTables& tables, proof::RtlNets nets)
    : title_(std::move(title)),
      nets_(std::move(nets)),
      compared_(tables.compared),
      reset_inputs_(tables.reset_inputs) {
  const auto registers = compared_.begin() + static_cast<std::ptrdiff_t>(tables.registers);
  inputs_ = nets_of("input", tables.inputs);
  wires_ = nets_of("register", {compared_.begin(), registers});
  for (auto& wire : nets_of("output", {registers, compared_.end()})) wires_.push_back(wire);
  if (nets_.width("mutsel") != mutsel_bits) throw InputError(title_ + ": no mutants");
  for (int i = 0; i < mutsel_bits; ++i) mutsel_.push_back(nets_.net("mutsel", i));

  std::set<Bit> known(mutsel_.begin(), mutsel_.end());
  for (const nets::Bits& input : inputs_) known.insert(input.begin(), input.end());
  for (const Bit pin : nets_.pins()) {
    if (!known.contains(pin)) clocks_.push_back(pin);
  }
  find_unreset(tables.registers);
}

void PlantedNets::find_unreset(std::size_t registers) {
  nets::Graph graph;
  std::map<std::size_t, Bit> given;
  for (const auto* all : {&nets_.pins(), &nets_.undefined()}) {
    for (const Bit net : *all) given[net.gate()] = nets::no;
  }
  for (const nets::Bits& input : inputs_) {
    for (const Bit net : input) given[net.gate()] = graph.input();
  }
  std::unordered_map<std::size_t, std::size_t> flip_flops;  // by gate
  for (std::size_t i = 0; i < nets_.flip_flops().size(); ++i) {
    const Bit held = given[nets_.flip_flops()[i].now.gate()] = graph.input();
    flip_flops[held.gate()] = i;
  }
  const nets::Bits bits = placed(graph, nets_.graph(), given);
  for (std::size_t i = 0; i < registers; ++i) {
    for (std::size_t b = 0; compared_[i].unreset && b < wires_[i].size(); ++b) {
      const Bit bit = placed_at(bits, wires_[i][b]);
      const auto own = flip_flops.find(bit.gate());
      if (own == flip_flops.end()) continue;
      unreset_.push_back({i, static_cast<int>(b), own->second, bit.is_inverted()});
    }
  }
}

std::vector<nets::Bits> PlantedNets::nets_of(const char* kind, const std::vector<Field>& fields) {
  std::vector<nets::Bits> all;
  for (const proof::RtlCell& cell : proof::located_fields(nets_, title_, kind, fields)) {
    all.push_back(cell.bits);
  }
  return all;
}

Lanes::Lanes(const PlantedNets& rtl, const std::vector<unsigned>& numbers) : rtl_(rtl) {
  for (std::size_t lane = 0; lane < numbers.size(); ++lane) all_.set(lane);
  place(numbers);
  std::vector<Bit> roots = next_;
  for (const auto& wire : wires_) roots.insert(roots.end(), wire.begin(), wire.end());
  planes_ = std::make_unique<nets::Planes>(graph_, roots, numbers.size());
  for (const auto& [bit, plane] : controls_) planes_->give(bit, plane);
  for (std::size_t i = 0; i < held_.size(); ++i) {
    if (planes_->root(held_[i]).at == 0) continue;  // nothing reads it
    rising_.push_back(planes_->flip_flop(held_[i], next_[i], edges_[i].rising));
    const Plane& falling = edges_[i].falling;
    if ((falling & all_).any()) falling_.push_back(planes_->flip_flop(held_[i], next_[i], falling));
  }
  for (const auto& wire : wires_) {
    auto& own = compared_.emplace_back();
    for (const Bit b : wire) own.push_back(planes_->root(b));
  }
}

// By gate the number in constants_ of what it is in each lane, where that follows from mutsel, and
// from the clock, which is so.
std::vector<std::uint32_t> Lanes::lane_constants(const std::vector<unsigned>& numbers, bool clock) {
  const auto& gates = rtl_.nets_.graph().gates();
  std::vector<std::uint32_t> all(gates.size(), none);
  const auto put = [&](std::size_t gate, const Plane& plane) {
    all[gate] = static_cast<std::uint32_t>(constants_.size());
    constants_.push_back(plane);
  };
  put(nets::no.gate(), Plane::all(false));
  for (std::size_t i = 0; i < rtl_.mutsel_.size(); ++i) {
    Plane plane;
    for (std::size_t lane = 0; lane < numbers.size(); ++lane) {
      if ((numbers[lane] >> i & 1) != 0) plane.set(lane);
    }
    put(rtl_.mutsel_[i].gate(), plane);
  }
  for (const Bit net : rtl_.clocks_) put(net.gate(), Plane::all(clock));
  for (const Bit net : rtl_.nets_.undefined()) put(net.gate(), Plane::all(false));
  for (std::size_t i = 0; i < gates.size(); ++i) {
    const auto& [kind, a, b, c, number] = gates[i];
    if (!gates[i].is_logic() || all[a.gate()] == none || all[b.gate()] == none ||
        all[c.gate()] == none) {
      continue;
    }
    const Plane x = constant(all, a), y = constant(all, b), z = constant(all, c);
    put(i, kind == nets::Gate::and_gate   ? x & y
           : kind == nets::Gate::xor_gate ? x ^ y
                                          : (x & y) | (~x & z));
  }
  return all;
}

// What a bit with such a number is.
Plane Lanes::constant(const std::vector<std::uint32_t>& all, Bit bit) const {
  return constants_[all[bit.gate()]] ^ Plane::all(bit.is_inverted());
}

void Lanes::place(const std::vector<unsigned>& numbers) {
  const auto& gates = rtl_.nets_.graph().gates();
  const auto low = lane_constants(numbers, false), high = lane_constants(numbers, true);
  find_edges(low, high);

  nets::Bits bits(gates.size());
  std::vector<bool> is_made(gates.size());
  const auto make = [&](std::size_t gate) {
    is_made[gate] = true;
    return bits[gate] = graph_.input();
  };
  for (const nets::Bits& input : rtl_.inputs_) {
    auto& own = inputs_.emplace_back();
    for (const Bit net : input) own.push_back(make(net.gate()));
  }
  for (const auto& f : rtl_.nets_.flip_flops()) held_.push_back(make(f.now.gate()));
  // What is the same in all lanes is folded, so that only the mutants in the lanes are left.
  const auto bit_of = [&](Bit net) {
    const std::size_t gate = net.gate();
    if (is_made[gate] || low[gate] == none) return placed_at(bits, net);
    const Plane& plane = constants_[low[gate]];
    if (plane != constants_[high[gate]])
      throw InputError(rtl_.title_ + ": its RTL reads the clock");
    is_made[gate] = true;
    if (!(plane & all_).any()) {
      bits[gate] = nets::no;
    } else if (!(~plane & all_).any()) {
      bits[gate] = nets::yes;
    } else {
      controls_.emplace_back(make(gate), plane);
    }
    return placed_at(bits, net);
  };
  for (std::size_t i = 0; i < gates.size(); ++i) {
    if (!gates[i].is_logic() || low[i] != none) continue;
    for (const Bit read : {gates[i].a, gates[i].b, gates[i].c}) bit_of(read);
    bits[i] = remade(graph_, gates[i], bits);
  }
  for (const auto& f : rtl_.nets_.flip_flops()) next_.push_back(bit_of(f.next));
  for (const nets::Bits& wire : rtl_.wires_) {
    auto& own = wires_.emplace_back();
    for (const Bit net : wire) own.push_back(bit_of(net));
  }
  constants_.clear();
}

// A mutant of a clock: in its lane the flip-flops keep what they hold, or take the next on the
// other edge.
void Lanes::find_edges(const std::vector<std::uint32_t>& low,
                       const std::vector<std::uint32_t>& high) {
  for (const auto& f : rtl_.nets_.flip_flops()) {
    if (!f.clock) {
      edges_.push_back({Plane::all(true), Plane::all(false)});
      continue;
    }
    if (low[f.clock->gate()] == none) {
      throw InputError(rtl_.title_ + ": its RTL makes a clock of its own");
    }
    const Plane before = constant(low, *f.clock), behind = constant(high, *f.clock);
    edges_.push_back({~before & behind, before & ~behind});
    if (f.falls) std::swap(edges_.back().rising, edges_.back().falling);
  }
}

void Lanes::drive(std::size_t input, Word value) {
  const std::vector<Bit>& bits = inputs_[input];
  for (std::size_t b = 0; b < bits.size(); ++b) {
    planes_->give(bits[b], Plane::all(bit(value, static_cast<int>(b))));
  }
}

void Lanes::drive(const std::vector<Word>& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) drive(i, inputs[i]);
}

// The clock falls as the inputs of the next one are given: what is clocked by that edge sees them.
void Lanes::settle() {
  if (!falling_.empty() && !std::exchange(is_first_, false)) {
    planes_->run();
    planes_->edge(falling_);
  }
  planes_->run();
}

void Lanes::rise() { planes_->edge(rising_); }

Word Lanes::value(std::size_t compared, std::size_t lane) const {
  return planes_->value(compared_[compared], lane);
}

Plane Lanes::differing(std::size_t compared, Word value) const {
  return planes_->differing(compared_[compared], value);
}

void Lanes::power_up(const std::vector<bool>& held) {
  const auto& flip_flops = rtl_.nets_.flip_flops();
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const char initial = flip_flops[i].initial;
    const bool is_given = initial == '0' || initial == '1';
    planes_->give(held_[i], Plane::all(is_given ? initial == '1' : held[i]));
  }
  is_first_ = true;
}

void Lanes::reset() {
  for (int i = 0; i < rtl_.reset_inputs_.clocks; ++i) {
    drive(rtl_.reset_inputs_.inputs);
    settle();
    rise();
  }
}

void Lanes::begin(std::uint32_t seed) {
  Random random(seed);
  std::vector<bool> held(held_.size());
  for (std::size_t i = 0; i < held.size(); ++i) held[i] = random.next() >> 63 != 0;
  power_up(held);
  reset();
  at_work_ = all_;
  takes_over_ = true;
}

Plane Lanes::not_reset() {
  constexpr std::uint32_t power_ups = 64;
  Plane depends;
  std::vector<Plane> first;
  for (std::uint32_t seed = 0; seed < power_ups; ++seed) {
    begin(seed);
    for (std::size_t i = 0; i < held_.size(); ++i) {
      const Plane now = planes_->get(held_[i]);
      if (seed == 0) first.push_back(now);
      depends = depends | (first[i] ^ now);
    }
  }
  return depends & all_;
}

// The cone of influence: back from what is compared, through flip-flops too.
Plane Lanes::unread() const {
  const auto& gates = graph_.gates();
  std::unordered_map<std::size_t, Bit> next;  // of what a flip-flop holds, by gate
  for (std::size_t i = 0; i < held_.size(); ++i) next[held_[i].gate()] = next_[i];
  std::vector<bool> is_in(gates.size());
  std::vector<std::size_t> left;
  const auto add = [&](Bit bit) {
    if (is_in[bit.gate()]) return;
    is_in[bit.gate()] = true;
    left.push_back(bit.gate());
  };
  for (const auto& wire : wires_) std::for_each(wire.begin(), wire.end(), add);
  while (!left.empty()) {
    const std::size_t gate = left.back();
    left.pop_back();
    for (const Bit bit : {gates[gate].a, gates[gate].b, gates[gate].c}) add(bit);
    if (const auto held = next.find(gate); held != next.end()) add(held->second);
  }
  Plane changing, reaching;
  const auto add_where_other = [&](Bit bit, const Plane& plane) {
    const Plane other = plane ^ Plane::all(plane.lane(0));
    changing = changing | other;
    if (is_in[bit.gate()]) reaching = reaching | other;
  };
  for (const auto& [bit, plane] : controls_) add_where_other(bit, plane);
  for (std::size_t i = 0; i < held_.size(); ++i) {
    add_where_other(held_[i], edges_[i].rising);
    add_where_other(held_[i], edges_[i].falling);
  }
  return changing & ~reaching & all_;
}

std::vector<Lanes::Killed> Lanes::clock(const Watched& seen) {
  // The model has taken over what no reset reaches.
  if (std::exchange(takes_over_, false)) {
    for (const auto& u : rtl_.unreset_) {
      planes_->give(held_[u.flip_flop],
                    Plane::all(bit(seen.expected[u.wire], u.bit) != u.is_inverted));
    }
  }
  drive(seen.inputs);
  settle();

  std::vector<Killed> killed;
  for (std::size_t i = 0; i < compared_.size(); ++i) {
    if (!seen.is_compared[i]) continue;
    const Plane different = differing(i, seen.expected[i]) & at_work_;
    if (!different.any()) continue;
    for (std::size_t w = 0; w < different.words.size(); ++w) {
      for (std::uint64_t left = different.words[w]; left != 0; left &= left - 1) {
        killed.push_back({64 * w + static_cast<std::size_t>(std::countr_zero(left)),
                          label_of(rtl_.compared_[i])});
      }
    }
    at_work_ = at_work_ & ~different;
  }
  rise();
  return killed;
}

}  // namespace cosim::mutation
