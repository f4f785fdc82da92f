#include "tb/proof/cnf.h"

#include "tb/proof/sat.h"
#include "tb/support/interrupt.h"

namespace cosim::proof {
namespace {

using nets::Bit;
using nets::Bits;

// What a gate gives (Tseitin's encoding).
Sat::Literal gate_of(Sat& sat, nets::Gate kind, Sat::Literal a, Sat::Literal b, Sat::Literal c) {
  if (kind == nets::Gate::and_gate) return sat.and_of({a, b});
  const Sat::Literal is = sat.variable();
  const Sat::Literal otherwise = kind == nets::Gate::mux ? c : b;
  const Sat::Literal then = kind == nets::Gate::mux ? b : -b;
  sat.clause({-a, -then, is});
  sat.clause({-a, then, -is});
  sat.clause({a, -otherwise, is});
  sat.clause({a, otherwise, -is});
  return is;
}

}  // namespace

Satisfied satisfy(const nets::Graph& logic, const Bits& all, const Bits& any,
                  std::chrono::steady_clock::time_point until) {
  Sat sat([until] {
    return InterruptGuard::signal() != 0 || std::chrono::steady_clock::now() >= until;
  });
  Bits roots = all;
  roots.insert(roots.end(), any.begin(), any.end());
  const std::vector<bool> is_read = logic.cone(roots);
  const auto& nodes = logic.gates();
  std::vector<Sat::Literal> literals(nodes.size());
  const auto of = [&](Bit lit) {
    const Sat::Literal is = literals[lit.gate()];
    return lit.is_inverted() ? -is : is;
  };
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const bool is_logic = nodes[n].is_logic();
    if (is_logic && !is_read[n]) continue;
    literals[n] = is_logic
                      ? gate_of(sat, nodes[n].kind, of(nodes[n].a), of(nodes[n].b), of(nodes[n].c))
                      : sat.variable();
    if (nodes[n].kind == nets::Gate::constant) sat.clause({-literals[n]});
  }
  for (const Bit lit : all) sat.clause({of(lit)});
  std::vector<Sat::Literal> one;
  for (const Bit lit : any) one.push_back(of(lit));
  sat.clause(one);
  Satisfied satisfied{sat.solve(), {}};
  InterruptGuard::check();
  if (satisfied.answer != Answer::sat) return satisfied;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n].kind == nets::Gate::input) satisfied.inputs.push_back(sat.holds(literals[n]));
  }
  return satisfied;
}

}  // namespace cosim::proof
