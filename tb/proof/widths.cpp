#include "tb/proof/widths.h"

#include "tb/proof/machines.h"

namespace cosim::proof {

Theorem at_every_width(const std::string& design, const std::string& sentence,
                       Asked (*ask)(const Widths&)) {
  Theorem theorem{design, sentence, {}, {}};
  for (const auto& machine : built_machines()) {
    if (!machine.title.starts_with(design + ' ')) continue;
    auto [script, wrong] = ask(machine.nets().machine.parameters);
    Script possible = script;
    possible.ask(truth(true));
    theorem.premises.push_back({machine.title, possible.text()});
    script.ask(wrong.expression());
    theorem.negated.push_back({machine.title, script.text()});
  }
  return theorem;
}

BitVector free_number(Script& script, const std::string& name, int width) {
  return BitVector::unsigned_code(script.declare(name, bit_vector(width)), width);
}
BitVector free_signed(Script& script, const std::string& name, int width) {
  return BitVector::signed_code(script.declare(name, bit_vector(width)), width);
}

}  // namespace cosim::proof
