#include "tb/proof/sat.h"

#include <cadical.hpp>
#include <utility>

namespace cosim::proof {

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

}  // namespace cosim::proof
