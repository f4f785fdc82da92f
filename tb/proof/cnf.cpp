#include "tb/proof/cnf.h"

#include "tb/proof/sat.h"
#include "tb/support/interrupt.h"

namespace cosim::proof {
namespace {

using Lit = Aig::Lit;
using Lits = std::vector<Lit>;

// The nodes that these are made of.
std::vector<bool> cone(const Aig& logic, const Lits& all, const Lits& any) {
  const auto& nodes = logic.nodes();
  std::vector<bool> read(nodes.size());
  for (const Lits* lits : {&all, &any}) {
    for (const Lit lit : *lits) read[lit / 2] = true;
  }
  for (std::size_t n = nodes.size(); n-- > 0;) {
    if (read[n] && nodes[n].kind == Aig::Kind::both) {
      read[nodes[n].a / 2] = read[nodes[n].b / 2] = true;
    }
  }
  return read;
}

}  // namespace

Satisfied satisfy(const Aig& logic, const Lits& all, const Lits& any,
                  std::chrono::steady_clock::time_point until) {
  Sat sat([until] {
    return InterruptGuard::signal() != 0 || std::chrono::steady_clock::now() >= until;
  });
  const std::vector<bool> is_read = cone(logic, all, any);
  const auto& nodes = logic.nodes();
  std::vector<Sat::Literal> literals(nodes.size());
  const auto of = [&](Lit lit) {
    const Sat::Literal is = literals[lit / 2];
    return (lit & 1U) != 0 ? -is : is;
  };
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const bool is_gate = nodes[n].kind == Aig::Kind::both;
    if (is_gate && !is_read[n]) continue;
    literals[n] = is_gate ? sat.and_of({of(nodes[n].a), of(nodes[n].b)}) : sat.variable();
    if (nodes[n].kind == Aig::Kind::constant) sat.clause({-literals[n]});
  }
  for (const Lit lit : all) sat.clause({of(lit)});
  std::vector<Sat::Literal> one;
  for (const Lit lit : any) one.push_back(of(lit));
  sat.clause(one);
  Satisfied satisfied{sat.solve(), {}};
  InterruptGuard::check();
  if (satisfied.answer != Answer::sat) return satisfied;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n].kind == Aig::Kind::input) satisfied.inputs.push_back(sat.holds(literals[n]));
  }
  return satisfied;
}

}  // namespace cosim::proof
