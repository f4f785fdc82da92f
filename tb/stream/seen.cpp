#include "tb/stream/seen.h"

namespace cosim {

InterfaceSeen seen_of(const Giver& g) {
  const bool ready = g.own ? g.moved : g.i.ready.empty() || g.nets.ready.get();
  InterfaceSeen seen{g.offers, ready, g.taken, {}, {}};
  read(g.nets.cells, seen.actual);
  if (g.own && g.offers) {
    const auto words = (*g.given)[g.taken];
    seen.actual.assign(words.begin(), words.end());
  }
  seen.actual.resize(g.i.cells.size());
  seen.expected = seen.actual;
  return seen;
}

InterfaceSeen seen_of(const Taker& t) {
  InterfaceSeen seen{t.valid, t.ready, t.came, {}, {}};
  read(t.nets.cells, seen.actual);
  if (t.own && t.valid) seen.actual = t.words;
  seen.actual.resize(t.i.cells.size());
  seen.expected = seen.actual;
  // What is not valid means nothing.
  if (t.valid && t.came < t.expected->size()) {
    const auto words = (*t.expected)[t.came];
    seen.expected.assign(words.begin(), words.end());
  }
  return seen;
}

}  // namespace cosim
