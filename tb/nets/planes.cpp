#include "tb/nets/planes.h"

#include <utility>

namespace cosim::nets {

Planes::Planes(const Graph& graph, std::span<const Bit> roots, std::size_t lanes) : lanes_(lanes) {
  const auto& gates = graph.gates();
  std::vector<bool> needed(gates.size());
  for (const Bit b : roots) needed[b.gate()] = true;
  for (std::size_t i = gates.size(); i-- > 0;) {
    if (!needed[i]) continue;
    for (const Bit b : {gates[i].a, gates[i].b, gates[i].c}) needed[b.gate()] = true;
  }
  place_.resize(gates.size());
  std::uint32_t places = 1;
  for (std::size_t i = 1; i < gates.size(); ++i) {
    if (!needed[i]) continue;
    const Graph::Made& g = gates[i];
    place_[i] = places++;
    const auto of = [&](Bit b) { return place_[b.gate()]; };
    PlaneStep step{PlaneStep::both, of(g.a), of(g.b), of(g.c), place_[i]};
    switch (g.kind) {
      case Gate::both:
        if (g.a.is_opposite()) {
          step.act = g.b.is_opposite() ? PlaneStep::neither : PlaneStep::not_a;
        } else if (g.b.is_opposite()) {
          step.act = PlaneStep::not_b;
        }
        break;
      case Gate::differ:
        step.act = PlaneStep::differ;
        break;
      case Gate::choice:
        step.act = g.c.is_opposite() ? PlaneStep::turned_choice : PlaneStep::choice;
        break;
      case Gate::constant:
      case Gate::input:
        continue;
    }
    steps_.push_back(step);
  }
  memory_.resize(places);
}

void Planes::give(Bit input, const Plane& plane) {
  if (const std::uint32_t at = place_[input.gate()]; at != 0) memory_[at] = plane;
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

#define COSIM_STEPS(word)                                                              \
  for (const PlaneStep& s : steps) {                                                   \
    switch (s.act) {                                                                   \
      case PlaneStep::both:                                                            \
        m[s.gives] word = m[s.a] word & m[s.b] word;                                   \
        break;                                                                         \
      case PlaneStep::not_a:                                                           \
        m[s.gives] word = ~m[s.a] word & m[s.b] word;                                  \
        break;                                                                         \
      case PlaneStep::not_b:                                                           \
        m[s.gives] word = m[s.a] word & ~m[s.b] word;                                  \
        break;                                                                         \
      case PlaneStep::neither:                                                         \
        m[s.gives] word = ~(m[s.a] word | m[s.b] word);                                \
        break;                                                                         \
      case PlaneStep::differ:                                                          \
        m[s.gives] word = m[s.a] word ^ m[s.b] word;                                   \
        break;                                                                         \
      case PlaneStep::choice:                                                          \
        m[s.gives] word = m[s.c] word ^ (m[s.a] word & (m[s.b] word ^ m[s.c] word));   \
        break;                                                                         \
      case PlaneStep::turned_choice:                                                   \
        m[s.gives] word = ~m[s.c] word ^ (m[s.a] word & (m[s.b] word ^ ~m[s.c] word)); \
        break;                                                                         \
    }                                                                                  \
  }

COSIM_FOR_THIS_PROCESSOR
void run_all(std::span<const PlaneStep> steps, Plane* planes) {
  auto* const m = reinterpret_cast<Vector*>(planes);
  COSIM_STEPS()
}
void run_first_word(std::span<const PlaneStep> steps, Plane* m) { COSIM_STEPS(.words[0]) }

}  // namespace

void Planes::run() {
  if (lanes_ > 64) {
    run_all(steps_, memory_.data());
  } else {
    run_first_word(steps_, memory_.data());
  }
}

Plane Planes::get(Bit root) const {
  const Plane& p = memory_[place_[root.gate()]];
  return root.is_opposite() ? ~p : p;
}

}  // namespace cosim::nets
