// A question about the model and the RTL as a script for solvers.
#pragma once

#include <string>
#include <vector>

#include "tb/proof/located.h"
#include "tb/proof/machine.h"
#include "tb/proof/rtl.h"

namespace cosim::proof {

/// Declares what is free and defines all the rest: the RTL's inputs are the model's, its registers
/// what the model says, or free as well.
class Question {
 public:
  /// InputError where the tables do not name every register and port of the RTL, or the RTL has not
  /// all that they name.
  Question(const MachineFormula& m, const Rtl& rtl, bool registers_free);

  Script& script() { return script_; }
  /// Of the state before the clock and of its inputs.
  void assume_hypotheses();

  /// Whether a field differs that is compared, with names for both sides that a reader of the
  /// script finds: model.FIELD, rtl.FIELD and `what`. By their arms (arms.h) where that is asked.
  Expression differs(const char* what, const Wire& expected, const Expression& actual,
                     bool by_arms = false);
  /// What the RTL gives for output number i during the clock.
  Expression output(std::size_t i) const { return during(rtl_, at_.outputs[i]); }
  /// What register number i shows during the first clock, and holds after the clock that the
  /// question has come to.
  Expression shown(std::size_t i) const { return during(rtl_, at_.registers[i]); }
  Expression after(std::size_t i) const { return now(proof::after(rtl_, at_.registers[i])); }

  /// One more clock of a reset: of its inputs those that reset are the same, the others free.
  void reset_again();

 private:
  struct Located {
    std::vector<RtlCell> inputs, outputs, registers;  // in the order of the tables
    // By free symbol: the codes of its bits, highest first; none where no table names it.
    std::vector<std::vector<Expression>> codes;
  };
  // `registers` are those of the machine, with what they hold.
  Located all_located(const std::vector<Wire>& registers) const;
  Expression held(const Wire& w);

  // A term on the clock that the question has come to.
  template <class Term>
  Term now(Term term) const {
    for (int i = 0; i < clock_; ++i) term = on_next_clock(term);
    return term;
  }

  const MachineFormula& m_;
  const Rtl& rtl_;
  Script script_;
  Located at_;
  int clock_ = 0;
};

}  // namespace cosim::proof
