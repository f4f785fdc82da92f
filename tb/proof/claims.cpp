#include "tb/proof/claims.h"

#include <fmt/core.h>

#include "tb/proof/script_question.h"
#include "tb/proof/terms.h"

namespace cosim::proof {
namespace {

constexpr const char* kAsserts = "what the RTL asserts is so";

Expression any_fails(const std::vector<Named>& all) {
  Expression any = truth(false);
  for (const Named& n : all) any = disjunction(any, negation(n.condition));
  return any;
}

// ", but for a, b": what the model takes over from the RTL, of an array once, not each element.
std::string taken_over(const MachineFormula& m) {
  std::string text;
  for (const Wire& w : m.reset_state) {
    if (!w.field.unreset || w.field.index > 0) continue;
    text += std::string(text.empty() ? ", but for " : ", ") + w.field.name;
  }
  return text;
}

// Of a machine that nothing resets.
Claim claim_initial(const MachineFormula& m, const Rtl& rtl) {
  Question q(m, rtl, true);
  for (const std::string& term : rtl.initial()) q.script().assume({term, boolean});
  Expression wrong = any_fails(m.invariant_in_reset);
  for (std::size_t i = 0; i < m.reset_state.size(); ++i) {
    if (m.reset_state[i].field.unreset) continue;
    wrong = disjunction(wrong, q.differs(kInitial, m.reset_state[i], q.shown(i)));
  }
  q.script().ask(wrong);
  return {"base case: they begin the same" + taken_over(m),
          Answer::unsat,
          {{{"at first"}, q.script().text()}},
          {}};
}

}  // namespace

Claim claim_base_case(const MachineFormula& m, const Rtl& rtl) {
  if (m.reset_clocks == 0) return claim_initial(m, rtl);
  Question q(m, rtl, true);
  for (const Wire& given : m.reset_inputs) {
    q.script().assume(equal(symbol("in", given.field), given.code));
  }
  for (int i = 1; i < m.reset_clocks; ++i) q.reset_again();
  Expression wrong = any_fails(m.invariant_in_reset);
  for (std::size_t i = 0; i < m.reset_state.size(); ++i) {
    const Wire& w = m.reset_state[i];
    if (w.field.unreset) continue;
    wrong = disjunction(wrong, q.differs(kAfter, w, q.after(i)));
    // A longer reset may take the model through states of its own.
    if (m.reset_clocks > 1) continue;
    wrong = disjunction(wrong, where_compared(w, negation(equal(m.after[i].code, w.code))));
  }
  q.script().ask(wrong);
  return {(m.reset_clocks == 1 ? "base case: a reset makes them the same"
                               : fmt::format("base case: {} clocks of a reset make them the same",
                                             m.reset_clocks)) +
              taken_over(m),
          Answer::unsat,
          {{{"any clock"}, q.script().text()}},
          {}};
}

namespace {

// A claim of one clock, whose counterexamples have all that happens on it.
class OneClock {
 public:
  OneClock(const std::string& what, const MachineFormula& m, const Rtl& rtl)
      : question(m, rtl, false), claim{what, Answer::unsat, {}, {}}, by_arms_(m.parts.empty()) {
    question.assume_hypotheses();
    for (const Wire& w : m.inputs) claim.terms.push_back(w.code.text());
    for (const Wire& w : m.state) claim.terms.push_back(w.code.text());
    for (std::size_t i = 0; i < m.invariant_after.size(); ++i) {
      const Expression& kept = m.invariant_after[i].condition;
      claim.terms.push_back(question.script().define(term_of_invariant(i), kept).text());
    }
  }
  Expression differs(const char* what, const Wire& w, const Expression& actual) {
    claim.terms.push_back(term_of("model", w.field) + what);
    claim.terms.push_back(term_of("rtl", w.field) + what);
    return question.differs(what, w, actual, by_arms_);
  }

  Question question;
  Claim claim;

 private:
  bool by_arms_;  // parts of the model's own cut it otherwise
};

}  // namespace

Claim claim_asserts(const MachineFormula& m, const Rtl& rtl) {
  OneClock clock(kAsserts, m, rtl);
  Question& q = clock.question;
  for (std::size_t i = 0; i < m.after.size(); ++i) clock.differs(kAfter, m.after[i], q.after(i));
  for (std::size_t i = 0; i < m.outputs.size(); ++i) {
    clock.differs(kOutput, m.outputs[i], q.output(i));
  }
  Expression wrong = truth(false);
  for (const Expression& asserted : rtl.asserted()) {
    wrong = disjunction(wrong, negation(asserted));
  }
  q.script().ask(wrong);
  clock.claim.queries.push_back({{"any assertion"}, q.script().text()});
  return clock.claim;
}

Claim claim_step(const MachineFormula& m, const Rtl& rtl) {
  OneClock clock("inductive step: every clock keeps them the same", m, rtl);
  Question& q = clock.question;
  Claim& claim = clock.claim;
  const auto differs = [&](const char* what, const Wire& w, const Expression& actual) {
    return clock.differs(what, w, actual);
  };
  // Many wide words at once take a solver many times as long as one after the other.
  Expression narrow = any_fails(m.invariant_after), after = narrow;
  std::vector<Named> wide;
  const auto sort_in = [&](const std::string& what, const Wire& w, const Expression& wrong) {
    constexpr int words_at_once = 16;  // those of a memory are alike, and each is little work
    if (w.field.width == 1) {
      narrow = disjunction(narrow, wrong);
    } else if (w.field.index % words_at_once > 0) {
      wide.back().condition = disjunction(wide.back().condition, wrong);
    } else {
      const bool from_first = w.field.index < words_at_once;
      wide.push_back({what + (from_first ? w.field.name : label_of(w.field) + " and on"), wrong});
    }
  };
  for (std::size_t i = 0; i < m.after.size(); ++i) {
    const Expression wrong = differs(kAfter, m.after[i], q.after(i));
    after = disjunction(after, wrong);
    if (m.parts.empty()) sort_in("register ", m.after[i], wrong);
  }
  for (std::size_t i = 0; i < m.seen.size(); ++i) {
    sort_in("register seen ", m.seen[i], q.differs(kSeen, m.seen[i], q.shown(i)));
  }
  for (std::size_t i = 0; i < m.outputs.size(); ++i) {
    sort_in("output ", m.outputs[i], differs(kOutput, m.outputs[i], q.output(i)));
  }

  const auto ask = [&](const std::string& what, const Expression& wrong) {
    Script script = q.script();
    script.ask(wrong);
    claim.queries.push_back({{what}, script.text()});
  };
  for (const Named& w : wide) ask(w.name, w.condition);
  ask("single bits and the invariant", narrow);
  if (m.parts.empty()) return claim;
  for (const Named& part : m.parts) {
    ask(part.name, conjunction(part.condition, after));
    q.script().assume(negation(part.condition));
  }
  ask("any other clock", after);
  return claim;
}

Claim claim_cases(const MachineFormula& m) {
  Script script("QF_BV");
  for (const auto* wires : {&m.inputs, &m.state}) {
    for (const Wire& w : *wires) script.declare(w.code.text(), w.code.sort());
  }
  for (const auto* all : {&m.invariant, &m.legal}) {
    for (const Named& n : *all) script.assume(n.condition);
  }
  Query query;
  for (const Named& n : m.cases) {
    query.asks.push_back(n.name);
    script.ask_apart(n.condition);
  }
  query.script = script.text();
  const std::string what =
      m.cases.size() == 1
          ? "vacuity check: " + m.cases.front().name + " is possible"
          : fmt::format("vacuity check: each of {} cases is possible", m.cases.size());
  return {what, Answer::sat, {query}, {}};
}

Claim claim_legal(const MachineFormula& m) {
  Script script("QF_BV");
  for (const Wire& w : m.state) script.declare(w.code.text(), w.code.sort());
  for (const Named& n : m.invariant) script.assume(n.condition);
  script.ask(any_fails(m.idle));
  return {"legal inputs in every state", Answer::unsat, {{{"any state"}, script.text()}}, {}};
}

std::vector<Claim> claims_of(const MachineFormula& m, const nets::Model& model,
                             const Source& source) {
  const auto both = [](Claim claim, NetQuestions nets) {
    claim.nets = std::make_shared<const NetQuestions>(std::move(nets));
    return claim;
  };
  std::vector<Claim> all, asserts;
  if (m.unobserved.empty()) {
    const auto [rtl, rtl_nets] = read_both(source);
    all.push_back(both(claim_base_case(m, rtl), nets_of_base_case(model, rtl_nets)));
    all.push_back(both(claim_step(m, rtl), nets_of_step(model, rtl_nets)));
    if (!rtl.asserted().empty()) asserts.push_back(claim_asserts(m, rtl));
  } else {
    all.push_back({"from reset: always the same", Answer::unsat, {}, {}});
    Source kept = source;
    kept.keeps_statements = true;
    if (!RtlNets(kept).unmet().empty()) asserts.push_back({kAsserts, Answer::unsat, {}, {}});
  }
  for (Claim& claim : asserts) claim.from_reset = Happens::assertion;
  for (Claim& claim : all) claim.from_reset = Happens::differ;
  all.push_back(both(claim_cases(m), nets_of_cases(model)));
  if (!m.legal.empty()) {
    all.push_back(both(claim_legal(m), nets_of_legal(model)));
    all.back().from_reset = Happens::stuck;
  }
  all.insert(all.end(), asserts.begin(), asserts.end());
  return all;
}

}  // namespace cosim::proof
