#include "tb/nets/planes.h"

#include <algorithm>
#include <array>

namespace cosim::nets {
namespace {

constexpr std::size_t plane_words = plane_lanes / 64;

PlaneStep::Act act_of(const Graph::Made& g) {
  switch (g.kind) {
    case Gate::and_gate:
      if (g.a.is_inverted()) return g.b.is_inverted() ? PlaneStep::neither : PlaneStep::not_a;
      return g.b.is_inverted() ? PlaneStep::not_b : PlaneStep::both;
    case Gate::xor_gate:
      return PlaneStep::differ;
    default:
      return g.c.is_inverted() ? PlaneStep::turned_choice : PlaneStep::choice;
  }
}

// `gates`, by number and in rising order, so ordered that each comes behind the ones it reads and
// that as many as can be found of one act follow each other: what runs them one after the other
// then seldom has to find out anew what to do.
std::vector<std::uint32_t> alike_together(const Graph& graph,
                                          const std::vector<std::uint32_t>& gates) {
  const auto& made = graph.gates();
  const auto act = [&](std::uint32_t gate) { return act_of(made[gate]); };
  std::vector<std::vector<std::uint32_t>> readers(made.size());
  std::vector<std::uint32_t> waits_for(made.size());
  for (const std::uint32_t gate : gates) {
    for (const Bit b : {made[gate].a, made[gate].b, made[gate].c}) {
      const auto read = static_cast<std::uint32_t>(b.gate());
      if (made[read].kind == Gate::constant || made[read].kind == Gate::input) continue;
      readers[read].push_back(gate);
      ++waits_for[gate];
    }
  }
  std::array<std::vector<std::uint32_t>, 8> ready;
  for (const std::uint32_t gate : gates) {
    if (waits_for[gate] == 0) ready[act(gate)].push_back(gate);
  }
  std::vector<std::uint32_t> order;
  while (order.size() < gates.size()) {
    auto& most = *std::ranges::max_element(ready, {}, [](const auto& of) { return of.size(); });
    // Some that become ready meanwhile have this act, too.
    while (!most.empty()) {
      const std::uint32_t gate = most.back();
      most.pop_back();
      order.push_back(gate);
      for (const std::uint32_t reader : readers[gate]) {
        if (--waits_for[reader] == 0) ready[act(reader)].push_back(reader);
      }
    }
  }
  return order;
}

}  // namespace

Planes::Planes(const Graph& graph, std::span<const Bit> roots, std::size_t lanes)
    : words_(lanes > 64 ? plane_words : 1) {
  const auto& gates = graph.gates();
  const std::vector<bool> needed = graph.cone(roots);
  place_.resize(gates.size());
  std::uint32_t places = 1;
  std::vector<std::uint32_t> run;
  for (std::uint32_t i = 1; i < gates.size(); ++i) {
    if (!needed[i]) continue;
    if (gates[i].kind == Gate::input) {
      place_[i] = places++;
    } else {
      run.push_back(i);
    }
  }
  for (const std::uint32_t i : alike_together(graph, run)) {
    const Graph::Made& g = gates[i];
    const auto of = [&](Bit b) { return place_[b.gate()]; };
    place_[i] = places++;
    steps_.push_back({act_of(g), of(g.a), of(g.b), of(g.c), place_[i]});
    if (steps_.size() > 1 && steps_[steps_.size() - 2].act == steps_.back().act) ends_.pop_back();
    ends_.push_back(static_cast<std::uint32_t>(steps_.size()));
  }
  memory_.resize((places * words_ + plane_words - 1) / plane_words);
}

namespace {

// The widest vectors that the processor has. Sanitizers cannot look into such a choice.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define COSIM_FOR_THIS_PROCESSOR [[gnu::target_clones("default", "avx2", "avx512f")]]
#else
#define COSIM_FOR_THIS_PROCESSOR
#endif

typedef std::uint64_t Vector __attribute__((vector_size(sizeof(Plane)), may_alias));

// M: what a plane is in the memory. A value of it is never passed on: how a vector is passed
// depends on the processor.
#define COSIM_ALL_OF(what)                            \
  for (; s != end; ++s) {                             \
    const M &a = m[s->a], &b = m[s->b], &c = m[s->c]; \
    (void)c;                                          \
    m[s->gives] = what;                               \
  }                                                   \
  break
template <class M>
[[gnu::always_inline]] inline void run_on(std::span<const PlaneStep> steps,
                                          std::span<const std::uint32_t> ends, M* m) {
  const PlaneStep* s = steps.data();
  for (const std::uint32_t behind : ends) {
    const PlaneStep* const end = steps.data() + behind;
    switch (s->act) {
      case PlaneStep::both:
        COSIM_ALL_OF(a & b);
      case PlaneStep::not_a:
        COSIM_ALL_OF(~a & b);
      case PlaneStep::not_b:
        COSIM_ALL_OF(a & ~b);
      case PlaneStep::neither:
        COSIM_ALL_OF(~(a | b));
      case PlaneStep::differ:
        COSIM_ALL_OF(a ^ b);
      case PlaneStep::choice:
        COSIM_ALL_OF(c ^ (a & (b ^ c)));
      case PlaneStep::turned_choice:
        COSIM_ALL_OF(~c ^ (a & (b ^ ~c)));
    }
  }
}
#undef COSIM_ALL_OF

template <class M>
[[gnu::always_inline]] inline void take_on(std::span<const PlaneFlipFlop> flip_flops, M* taken,
                                           M* m) {
  for (std::size_t i = 0; i < flip_flops.size(); ++i) {
    const PlaneRoot next = flip_flops[i].next;
    taken[i] = next.is_inverted ? ~m[next.at] : m[next.at];
  }
  for (std::size_t i = 0; i < flip_flops.size(); ++i) {
    const PlaneFlipFlop& f = flip_flops[i];
    const M& lanes = *reinterpret_cast<const M*>(&f.lanes);
    m[f.held] ^= lanes & (m[f.held] ^ taken[i]);
  }
}

template <class M>
[[gnu::always_inline]] inline void differ_on(std::span<const PlaneRoot> roots, Word value,
                                             const M* m, M* any) {
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const bool turned = roots[i].is_inverted != bit(value, static_cast<int>(i));
    *any |= turned ? ~m[roots[i].at] : m[roots[i].at];
  }
}

COSIM_FOR_THIS_PROCESSOR
void run_all(std::span<const PlaneStep> steps, std::span<const std::uint32_t> ends, Vector* m) {
  run_on(steps, ends, m);
}
COSIM_FOR_THIS_PROCESSOR
void take_all(std::span<const PlaneFlipFlop> flip_flops, Vector* taken, Vector* m) {
  take_on(flip_flops, taken, m);
}
COSIM_FOR_THIS_PROCESSOR
void differ_all(std::span<const PlaneRoot> roots, Word value, const Vector* m, Vector* any) {
  differ_on(roots, value, m, any);
}

Vector* vectors(std::vector<Plane>& planes) { return reinterpret_cast<Vector*>(planes.data()); }
const Vector* vectors(const std::vector<Plane>& planes) {
  return reinterpret_cast<const Vector*>(planes.data());
}
std::uint64_t* words(std::vector<Plane>& planes) { return planes.front().words.data(); }
const std::uint64_t* words(const std::vector<Plane>& planes) { return planes.front().words.data(); }

}  // namespace

void Planes::give(Bit input, const Plane& plane) {
  const std::size_t at = place_[input.gate()];
  if (at == 0) return;
  std::copy_n(plane.words.begin(), words_, words(memory_) + at * words_);
}

Plane Planes::get(Bit root) const {
  Plane p;
  std::copy_n(words(memory_) + place_[root.gate()] * words_, words_, p.words.begin());
  return root.is_inverted() ? ~p : p;
}

Word Planes::value(std::span<const PlaneRoot> roots, std::size_t lane) const {
  const std::uint64_t* const of_lane = words(memory_) + lane / 64;
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const std::uint64_t bit = of_lane[roots[i].at * words_] >> (lane % 64) & 1;
    value |= (bit ^ (roots[i].is_inverted ? 1 : 0)) << i;
  }
  return static_cast<Word>(value);
}

void Planes::run() {
  if (is_narrow()) {
    run_on(steps_, ends_, words(memory_));
  } else {
    run_all(steps_, ends_, vectors(memory_));
  }
}

void Planes::edge(std::span<const PlaneFlipFlop> flip_flops) {
  if (flip_flops.empty()) return;
  taken_.resize(std::max(taken_.size(), flip_flops.size()));
  if (is_narrow()) {
    take_on(flip_flops, words(taken_), words(memory_));
  } else {
    take_all(flip_flops, vectors(taken_), vectors(memory_));
  }
}

Plane Planes::differing(std::span<const PlaneRoot> roots, Word value) const {
  Plane any;
  if (is_narrow()) {
    differ_on(roots, value, words(memory_), any.words.data());
  } else {
    differ_all(roots, value, vectors(memory_), reinterpret_cast<Vector*>(&any));
  }
  return any;
}

}  // namespace cosim::nets
