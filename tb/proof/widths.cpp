#include "tb/proof/widths.h"

#include "tb/proof/machines.h"

namespace cosim::proof {

Theorem at_every_width(const std::string& design, const std::string& sentence,
                       Asked (*ask)(const Widths&)) {
  Claim claim{sentence, Answer::unsat, {}, {}}, premises{"its premises", Answer::sat, {}, {}};
  for (const auto& machine : built_machines()) {
    const MachineFormula formula = machine.formula();
    if (formula.design != design) continue;
    auto [script, wrong] = ask(formula.parameters);
    Script possible = script;
    possible.ask(truth(true));
    premises.queries.push_back({{machine.title}, possible.text()});
    script.ask(wrong.expression());
    claim.queries.push_back({{machine.title}, script.text()});
  }
  return {design, sentence, claim, premises};
}

Bits free_number(Script& script, const std::string& name, int width) {
  return Bits::unsigned_code(script.declare(name, bit_vector(width)), width);
}
Bits free_signed(Script& script, const std::string& name, int width) {
  return Bits::signed_code(script.declare(name, bit_vector(width)), width);
}

}  // namespace cosim::proof
