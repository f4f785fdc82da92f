#include "tb/stream/seen.h"

namespace cosim {

InterfaceSeen seen_of(const Giver& g) {
  const bool ready = g.own ? g.moved : g.i.ready.empty() || g.nets.ready.get() != 0;
  InterfaceSeen seen{g.offers, ready, g.taken, values_of(g.nets.cells), {}};
  if (g.own && g.offers) seen.actual.assign(g.given[g.taken].begin(), g.given[g.taken].end());
  seen.actual.resize(g.i.cells.size());
  seen.expected = seen.actual;
  return seen;
}

InterfaceSeen seen_of(const Taker& t) {
  InterfaceSeen seen{t.valid, t.ready, t.came, values_of(t.nets.cells), {}};
  if (t.own && t.valid) seen.actual = t.words;
  seen.actual.resize(t.i.cells.size());
  seen.expected = seen.actual;
  // What is not valid means nothing.
  if (t.valid && t.came < t.expected.size()) {
    seen.expected.assign(t.expected[t.came].begin(), t.expected[t.came].end());
  }
  return seen;
}

}  // namespace cosim
