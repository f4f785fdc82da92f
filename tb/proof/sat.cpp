#include "tb/proof/sat.h"

#include <cadical.hpp>
#include <utility>

#include "tb/util/interrupt.h"

namespace cosim::proof {

using nets::Bit;
using nets::Bits;

class Sat::Solver : public CaDiCaL::Terminator {
 public:
  explicit Solver(std::function<bool()> is_over) : is_over_(std::move(is_over)) {
    engine.set("quiet", 1);
    engine.configure("unsat");
    engine.connect_terminator(this);
  }
  ~Solver() override { engine.disconnect_terminator(); }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  bool terminate() override { return is_over_(); }

  CaDiCaL::Solver engine;

 private:
  std::function<bool()> is_over_;
};

Sat::Sat(std::function<bool()> is_over) : solver_(std::make_unique<Solver>(std::move(is_over))) {}
Sat::~Sat() = default;

void Sat::clause(std::initializer_list<Literal> literals) {
  for (const Literal literal : literals) solver_->engine.add(literal);
  solver_->engine.add(0);
}
void Sat::clause(const std::vector<Literal>& literals) {
  for (const Literal literal : literals) solver_->engine.add(literal);
  solver_->engine.add(0);
}

Sat::Literal Sat::and_of(const std::vector<Literal>& all) {
  const Literal out = variable();
  std::vector<Literal> one_is_not{out};
  for (const Literal literal : all) {
    clause({-out, literal});
    one_is_not.push_back(-literal);
  }
  clause(one_is_not);
  return out;
}
Sat::Literal Sat::xor_of(Literal a, Literal b) {
  const Literal out = variable();
  clause({-out, a, b});
  clause({-out, -a, -b});
  clause({out, -a, b});
  clause({out, a, -b});
  return out;
}
Sat::Literal Sat::choose(Literal condition, Literal then, Literal otherwise) {
  const Literal out = variable();
  clause({-condition, -then, out});
  clause({-condition, then, -out});
  clause({condition, -otherwise, out});
  clause({condition, otherwise, -out});
  return out;
}

Answer Sat::solve(const std::vector<Literal>& assumed) {
  constexpr int is_sat = 10, is_unsat = 20;
  for (const Literal literal : assumed) solver_->engine.assume(literal);
  const int said = solver_->engine.solve();
  return said == is_sat ? Answer::sat : said == is_unsat ? Answer::unsat : Answer::timed_out;
}

bool Sat::holds(Literal literal) const { return solver_->engine.val(literal) == literal; }

Clauses::Clauses(const nets::Graph& graph, const Bits& roots, Sat& sat)
    : graph_(graph), sat_(sat), reads_(graph_.gates().size()), literals_(reads_.size()) {
  literals_[0] = -sat.variable();
  sat.clause({-literals_[0]});
  for (const Bit root : roots) ++reads_[root.gate()];
  for (const nets::Graph::Made& gate : graph_.gates()) {
    for (const Bit read : {gate.a, gate.b, gate.c}) ++reads_[read.gate()];
  }
}

Sat::Literal Clauses::of(Bit bit) {
  std::vector<std::size_t> stack{bit.gate()};
  while (!stack.empty()) {
    const std::size_t at = stack.back(), open = stack.size();
    const Bits all = literals_[at] == 0 ? read_by(at) : Bits{};
    for (const Bit read : all) {
      if (literals_[read.gate()] == 0) stack.push_back(read.gate());
    }
    if (stack.size() > open) continue;
    stack.pop_back();
    if (literals_[at] == 0) literals_[at] = made(graph_.gates()[at].kind, all);
  }
  return literal(bit);
}

std::vector<bool> Clauses::inputs() const {
  std::vector<bool> all;
  for (const Bit input : graph_.inputs()) {
    const Sat::Literal is = literal(input);
    all.push_back(is != 0 && sat_.holds(is));
  }
  return all;
}

Sat::Literal Clauses::literal(Bit bit) const {
  const Sat::Literal is = literals_[bit.gate()];
  return bit.is_inverted() ? -is : is;
}

Bits Clauses::read_by(std::size_t number) const {
  const nets::Graph::Made& gate = graph_.gates()[number];
  if (!gate.is_logic()) return {};
  if (gate.kind == nets::Gate::mux) return {gate.a, gate.b, gate.c};
  if (gate.kind != nets::Gate::and_gate) return {gate.a, gate.b};
  Bits leaves, open{gate.a, gate.b};
  while (!open.empty()) {
    const Bit bit = open.back();
    const nets::Graph::Made& below = graph_.gates()[bit.gate()];
    open.pop_back();
    const bool is_own = !bit.is_inverted() && below.kind == nets::Gate::and_gate &&
                        reads_[bit.gate()] == 1 && literals_[bit.gate()] == 0;
    if (is_own) {
      open.push_back(below.a);
      open.push_back(below.b);
    } else {
      leaves.push_back(bit);
    }
  }
  return leaves;
}

Sat::Literal Clauses::made(nets::Gate kind, const Bits& read) {
  std::vector<Sat::Literal> all;
  for (const Bit bit : read) all.push_back(literal(bit));
  switch (kind) {
    case nets::Gate::and_gate:
      return sat_.and_of(all);
    case nets::Gate::xor_gate:
      return sat_.xor_of(all[0], all[1]);
    case nets::Gate::mux:
      return sat_.choose(all[0], all[1], all[2]);
    default:
      return sat_.variable();
  }
}

Satisfied satisfy(const nets::Graph& logic, const Bits& all, const Bits& any,
                  std::chrono::steady_clock::time_point until) {
  Sat sat([until] {
    return InterruptGuard::signal() != 0 || std::chrono::steady_clock::now() >= until;
  });
  Bits roots = all;
  roots.insert(roots.end(), any.begin(), any.end());
  Clauses clauses(logic, roots, sat);
  for (const Bit bit : all) sat.clause({clauses.of(bit)});
  std::vector<Sat::Literal> one;
  for (const Bit bit : any) one.push_back(clauses.of(bit));
  sat.clause(one);
  const Answer answer = sat.solve();
  InterruptGuard::check();
  return {answer, answer == Answer::sat ? clauses.inputs() : std::vector<bool>{}};
}

}  // namespace cosim::proof
