#include "tb/proof/claims.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"

namespace cosim::proof {
namespace {

std::string named(const char* side, const std::string& name) {
  return fmt::format("{}.{}", side, name);
}

// What a free symbol of the RTL is: bits of a field from `low` up.
struct Place {
  const Wire* wire = nullptr;
  int low = 0;
};

// An error where the RTL has a port that the table does not name.
void require_ports(const MachineFormula& m, const char* what, const std::vector<std::string>& ports,
                   const std::vector<Wire>& table) {
  for (const std::string& port : ports) {
    if (std::any_of(table.begin(), table.end(),
                    [&](const Wire& w) { return port == w.field.net; })) {
      continue;
    }
    throw InputError(
        fmt::format("{}: the RTL has an {} {} that no table names", m.design, what, port));
  }
}

// The tables name every register and port of the RTL, and the RTL has all that they name.
std::vector<Place> places(const MachineFormula& m, const Rtl& rtl) {
  require_ports(m, "input", rtl.inputs(), m.inputs);
  require_ports(m, "output", rtl.outputs(), m.outputs);
  std::vector<Place> all(rtl.free().size());
  const auto place = [&](const Wire& w, const std::string& name, bool is_register) {
    int low = w.field.width;
    for (const std::size_t i : rtl.pieces(name)) {
      low -= rtl.free()[i].width;
      if (rtl.free()[i].after.empty() == is_register || all[i].wire != nullptr) low = -1;
      all[i] = {&w, low};
    }
    if (low == 0) return;
    throw InputError(fmt::format("{}: the RTL has no {} {} of {} bits by itself", m.design,
                                 is_register ? "register" : "input", name, w.field.width));
  };
  for (const Wire& w : m.inputs) place(w, w.field.net, false);
  for (const Wire& w : m.registers) place(w, w.field.net, true);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].wire != nullptr || rtl.free()[i].after.empty()) continue;
    throw InputError(m.design + ": the RTL has a register that no table names");
  }
  return all;
}

// What a register's symbols stand for: its value where it means something, else anything.
Expression held(const Wire& w, Script& script) {
  if (!w.when) return w.code;
  const Expression any = script.declare(named("any", w.field.name), w.code.sort());
  return {"ite", w.code.sort(), {*w.when, w.code, any}};
}

// Declares what is free and defines all the rest: the RTL's inputs are the model's, its registers
// what the model says, or free as well.
class Question {
 public:
  Question(const MachineFormula& m, const Rtl& rtl, bool registers_free)
      : m_(m), rtl_(rtl), script_("QF_BV") {
    const std::vector<Place> all = places(m, rtl);
    for (const Wire& w : m.inputs) script_.declare(w.code.text(), w.code.sort());
    for (const Wire& w : m.state) script_.declare(w.code.text(), w.code.sort());
    std::map<const Wire*, Expression> held_by;
    for (const Wire& w : m.registers) held_by.emplace(&w, held(w, script_));
    for (const Wire& w : m.inputs) held_by.emplace(&w, w.code);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Rtl::Free& f = rtl.free()[i];
      const std::string sort = f.is_bool ? boolean : bit_vector(f.width);
      if (all[i].wire == nullptr || (registers_free && !f.after.empty())) {
        script_.declare(f.symbol, sort);
      } else {
        script_.define(f.symbol, as_sort(cut(held_by.at(all[i].wire), all[i].low, f.width), sort));
      }
    }
    script_.add(rtl.definitions());
  }

  Script& script() { return script_; }

  // Of the state before the clock and of its inputs.
  void assume_hypotheses() {
    for (const auto* all : {&m_.invariant, &m_.legal}) {
      for (const Named& n : *all) script_.assume(n.condition);
    }
  }

  // Whether a field differs that is compared, with names for both sides that a reader of the script
  // finds.
  Expression differs(const char* what, const Wire& expected, const Expression& actual) {
    const Expression e = script_.define(named("model", expected.field.name) + what, expected.code);
    const Expression a = script_.define(named("rtl", expected.field.name) + what, actual);
    return where_compared(expected, negation(equal(e, a)));
  }
  Expression output(const Wire& w) { return rtl_.wire(w.field.net); }
  // Of register number i.
  Expression after(std::size_t i) {
    std::optional<Expression> code;
    int width = 0;
    for (const std::size_t piece : rtl_.pieces(m_.registers[i].field.net)) {
      const Rtl::Free& f = rtl_.free()[piece];
      const Expression bits = as_code({f.after, f.is_bool ? boolean : bit_vector(f.width)});
      width += f.width;
      code = code ? Expression("concat", bit_vector(width), {*code, bits}) : bits;
    }
    return *code;
  }

 private:
  const MachineFormula& m_;
  const Rtl& rtl_;
  Script script_;
};

Expression any_fails(const std::vector<Named>& all) {
  Expression any = truth(false);
  for (const Named& n : all) any = disjunction(any, negation(n.condition));
  return any;
}

constexpr const char* kOutput = ".output";
constexpr const char* kAfter = ".after";

std::string broken_name(std::size_t i) { return fmt::format("model.kept.{}", i); }

}  // namespace

Claim claim_clear(const MachineFormula& m, const Rtl& rtl) {
  Question q(m, rtl, true);
  for (const Wire& given : m.clearing) {
    q.script().assume(equal(detail::symbol("in", given.field), given.code));
  }
  Expression wrong = any_fails(m.invariant_cleared);
  std::string taken;
  for (std::size_t i = 0; i < m.cleared.size(); ++i) {
    const Wire& w = m.cleared[i];
    if (w.field.unreset) {
      taken += std::string(taken.empty() ? ", but for " : ", ") + w.field.name;
      continue;
    }
    wrong = disjunction(wrong, q.differs(kAfter, w, q.after(i)));
    wrong = disjunction(wrong, where_compared(w, negation(equal(m.after[i].code, w.code))));
  }
  q.script().ask(wrong);
  return {"a clear makes them the same" + taken,
          Answer::unsat,
          {{{"any clock"}, q.script().text()}},
          {}};
}

Claim claim_step(const MachineFormula& m, const Rtl& rtl) {
  Question q(m, rtl, false);
  q.assume_hypotheses();
  Claim claim{"every clock keeps them the same", Answer::unsat, {}, {}};
  for (const Wire& w : m.inputs) claim.terms.push_back(w.code.text());
  for (const Wire& w : m.state) claim.terms.push_back(w.code.text());
  for (std::size_t i = 0; i < m.invariant_after.size(); ++i) {
    const Expression& kept = m.invariant_after[i].condition;
    claim.terms.push_back(q.script().define(broken_name(i), kept).text());
  }
  const auto differs = [&](const char* what, const Wire& w, const Expression& actual) {
    claim.terms.push_back(named("model", w.field.name) + what);
    claim.terms.push_back(named("rtl", w.field.name) + what);
    return q.differs(what, w, actual);
  };
  // Many wide words at once take a solver many times as long as one after the other.
  Expression narrow = any_fails(m.invariant_after), after = narrow;
  std::vector<Named> wide;
  const auto sort_in = [&](const std::string& what, const Wire& w, const Expression& wrong) {
    if (w.field.width == 1) {
      narrow = disjunction(narrow, wrong);
    } else {
      wide.push_back({what + w.field.name, wrong});
    }
  };
  for (std::size_t i = 0; i < m.after.size(); ++i) {
    const Expression wrong = differs(kAfter, m.after[i], q.after(i));
    after = disjunction(after, wrong);
    if (m.parts.empty()) sort_in("register ", m.after[i], wrong);
  }
  for (const Wire& w : m.outputs) sort_in("output ", w, differs(kOutput, w, q.output(w)));

  const auto ask = [&](const std::string& what, const Expression& wrong) {
    Script script = q.script();
    script.ask(wrong);
    claim.queries.push_back({{what}, script.text(), m.parts.empty()});
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

Claim claim_cases(const MachineFormula& m, const Rtl& rtl) {
  Question q(m, rtl, false);
  q.assume_hypotheses();
  Query query;
  for (const Named& n : m.cases) {
    query.asks.push_back(n.name);
    q.script().ask_apart(n.condition);
  }
  query.script = q.script().text();
  const std::string what = m.cases.size() == 1
                               ? m.cases.front().name + " is possible"
                               : fmt::format("each of {} cases is possible", m.cases.size());
  return {what, Answer::sat, {query}, {}};
}

Claim claim_legal(const MachineFormula& m) {
  Script script("QF_BV");
  for (const Wire& w : m.state) script.declare(w.code.text(), w.code.sort());
  for (const Named& n : m.invariant) script.assume(n.condition);
  script.ask(any_fails(m.idle));
  return {"legal inputs in every state", Answer::unsat, {{{"any state"}, script.text()}}, {}};
}

std::optional<Counterexample> counterexample(const MachineFormula& m,
                                             const std::map<std::string, std::string>& values) {
  bool whole = true;
  const auto word = [&](const std::string& term) {
    const auto found = values.find(term);
    if (found == values.end()) {
      whole = false;
      return Word{0};
    }
    const std::string& text = found->second;
    if (text == "true" || text == "false") return Word{text == "true"};
    const int base = text[1] == 'x' ? 16 : 2;
    return static_cast<Word>(std::stoull(text.substr(2), nullptr, base));
  };
  Counterexample c;
  for (const Wire& w : m.state) {
    const Word code = word(w.code.text());
    const Word value = is_signed(w.field) ? from_twos_complement(code, w.field.width) : code;
    c.state.push_back({w.field, value, value});
  }
  for (const Wire& w : m.inputs) {
    const Word code = word(w.code.text());
    c.inputs.push_back({w.field, code, code});
  }
  const auto pair = [&](const Field& f, const char* what) {
    return Value{f, word(named("model", f.name) + what), word(named("rtl", f.name) + what)};
  };
  for (const Wire& w : m.outputs) c.outputs.push_back(pair(w.field, kOutput));
  for (const Wire& w : m.after) c.after.push_back(pair(w.field, kAfter));
  for (std::size_t i = 0; i < m.invariant_after.size(); ++i) {
    if (word(broken_name(i)) == 0) c.broken.push_back(m.invariant_after[i].name);
  }
  if (!whole) return std::nullopt;
  return c;
}

}  // namespace cosim::proof
