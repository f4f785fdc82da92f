#include "tb/proof/claims.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/proof/located.h"

namespace cosim::proof {
namespace {

std::string named(const char* side, const Field& field) {
  return fmt::format("{}.{}", side, detail::term(field));
}

// An error where the RTL has a port, or a bit of one, that the table does not name.
void require_ports(const MachineFormula& m, const Rtl& rtl, const char* what,
                   const std::vector<std::string>& ports, const std::vector<RtlCell>& cells) {
  for (const std::string& port : ports) {
    std::vector<bool> named(static_cast<std::size_t>(rtl.width(port)));
    for (const RtlCell& c : cells) {
      for (int i = 0; port == c.wire && i < c.width; ++i) {
        named[static_cast<std::size_t>(c.low + i)] = true;
      }
    }
    const auto open = std::find(named.begin(), named.end(), false);
    if (open == named.end()) continue;
    if (std::find(named.begin(), named.end(), true) == named.end()) {
      throw InputError(
          fmt::format("{}: the RTL has an {} {} that no table names", m.design, what, port));
    }
    throw InputError(fmt::format("{}: {} {}: no field has its bit {}", m.design, what, port,
                                 open - named.begin()));
  }
}

struct Located {
  std::vector<RtlCell> inputs, outputs, registers;  // in the order of the tables
  /// By free symbol: the codes of its bits, highest first; none where no table names it.
  std::vector<std::vector<Expression>> codes;
};

// Bits of a free symbol that a cell of a table is.
struct Given {
  Piece piece;
  Expression code;
};

// The tables name every register and port of the RTL, and the RTL has all that they name.
// `registers` are those of the machine, with what they hold.
Located all_located(const MachineFormula& m, const Rtl& rtl, const std::vector<Wire>& registers) {
  Located all{located(rtl, m.design, "input", m.inputs),
              located(rtl, m.design, "output", m.outputs),
              located(rtl, m.design, "register", m.registers),
              {}};
  require_ports(m, rtl, "input", rtl.inputs(), all.inputs);
  require_ports(m, rtl, "output", rtl.outputs(), all.outputs);
  std::vector<std::vector<Given>> given(rtl.free().size());
  const auto place = [&](const Wire& w, const RtlCell& cell, bool is_register) {
    int left = cell.width;
    for (const Piece& p : pieces_of(rtl, cell)) {
      if (rtl.free()[p.free].after.empty() == is_register) break;
      left -= p.width;
      given[p.free].push_back({p, cut(w.code, left, p.width)});
    }
    if (left == 0) return;
    throw InputError(fmt::format("{}: the RTL has no {} {} of {} bits by itself", m.design,
                                 is_register ? "register" : "input", label_of(w.field),
                                 w.field.width));
  };
  for (std::size_t i = 0; i < m.inputs.size(); ++i) place(m.inputs[i], all.inputs[i], false);
  for (std::size_t i = 0; i < registers.size(); ++i) {
    place(registers[i], all.registers[i], true);
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    std::sort(given[i].begin(), given[i].end(),
              [](const Given& a, const Given& b) { return a.piece.low > b.piece.low; });
    int next = rtl.free()[i].width;
    std::vector<Expression> codes;
    for (const Given& g : given[i]) {
      next -= g.piece.width;
      if (g.piece.low != next) break;
      codes.push_back(g.code);
    }
    if (given[i].empty() && rtl.free()[i].after.empty()) {
      codes
          .clear();  // of an input of no table require_ports has said so; what is undefined is free
    } else if (next != 0 || codes.size() != given[i].size()) {
      throw InputError(m.design + (given[i].empty()
                                       ? ": the RTL has a register that no table names"
                                       : ": the RTL has bits that no field has, or two fields"));
    }
    all.codes.push_back(codes);
  }
  return all;
}

// What a register's symbols stand for: its value where it means something, else anything.
Expression held(const Wire& w, Script& script) {
  if (!w.when) return w.code;
  const Expression any = script.declare(named("any", w.field), w.code.sort());
  return {"ite", w.code.sort(), {*w.when, w.code, any}};
}

// Declares what is free and defines all the rest: the RTL's inputs are the model's, its registers
// what the model says, or free as well.
class Question {
 public:
  Question(const MachineFormula& m, const Rtl& rtl, bool registers_free)
      : m_(m), rtl_(rtl), script_("QF_BV") {
    for (const Wire& w : m.inputs) script_.declare(w.code.text(), w.code.sort());
    for (const Wire& w : m.state) script_.declare(w.code.text(), w.code.sort());
    std::vector<Wire> registers = m.registers;
    for (Wire& w : registers) w.code = held(w, script_);
    at_ = all_located(m, rtl, registers);
    for (std::size_t i = 0; i < at_.codes.size(); ++i) {
      const Rtl::Free& f = rtl.free()[i];
      const std::string sort = f.is_bool ? boolean : bit_vector(f.width);
      if (at_.codes[i].empty() || (registers_free && !f.after.empty())) {
        script_.declare(f.symbol, sort);
      } else {
        script_.define(f.symbol, as_sort(joined(at_.codes[i]), sort));
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
    const Expression e = script_.define(named("model", expected.field) + what, expected.code);
    const Expression a = script_.define(named("rtl", expected.field) + what, actual);
    return where_compared(expected, negation(equal(e, a)));
  }
  // What the RTL gives for output and register number i.
  Expression output(std::size_t i) { return during(rtl_, at_.outputs[i]); }
  Expression after(std::size_t i) { return now(proof::after(rtl_, at_.registers[i])); }
  // What register number i shows during the first clock.
  Expression shown(std::size_t i) { return during(rtl_, at_.registers[i]); }

  // One more clock of a clear: of its inputs those that clear are the same, the others free.
  void clear_again() {
    for (const Rtl::Free& f : rtl_.free()) {
      const std::string next = on_next_clock(now(f.symbol));
      if (f.after.empty()) {
        script_.declare(next, f.sort());
      } else {
        script_.define(next, {now(f.after), f.sort()});
      }
    }
    ++clock_;
    script_.add(now(rtl_.definitions()));
    for (const Wire& given : m_.clearing) {
      for (std::size_t i = 0; i < m_.inputs.size(); ++i) {
        if (detail::term(m_.inputs[i].field) != detail::term(given.field)) continue;
        script_.assume(equal(now(during(rtl_, at_.inputs[i])), given.code));
      }
    }
  }

 private:
  // A term on the clock that the question has come to.
  template <class Term>
  Term now(Term term) const {
    for (int i = 0; i < clock_; ++i) term = on_next_clock(term);
    return term;
  }

  const MachineFormula& m_;
  const Rtl& rtl_;
  Located at_;
  Script script_;
  int clock_ = 0;
};

Expression any_fails(const std::vector<Named>& all) {
  Expression any = truth(false);
  for (const Named& n : all) any = disjunction(any, negation(n.condition));
  return any;
}

// ", but for a, b": what the model takes over from the RTL, of an array once, not each element.
std::string taken_over(const MachineFormula& m) {
  std::string text;
  for (const Wire& w : m.cleared) {
    if (!w.field.unreset || w.field.index > 0) continue;
    text += std::string(text.empty() ? ", but for " : ", ") + w.field.name;
  }
  return text;
}

constexpr const char* kInitial = ".initial";
constexpr const char* kSeen = ".seen";
constexpr const char* kOutput = ".output";
constexpr const char* kAfter = ".after";

std::string broken_name(std::size_t i) { return fmt::format("model.kept.{}", i); }

}  // namespace

namespace {

// Of a machine that nothing clears.
Claim claim_initial(const MachineFormula& m, const Rtl& rtl) {
  Question q(m, rtl, true);
  for (const std::string& term : rtl.initial()) q.script().assume({term, boolean});
  Expression wrong = any_fails(m.invariant_cleared);
  for (std::size_t i = 0; i < m.cleared.size(); ++i) {
    if (m.cleared[i].field.unreset) continue;
    wrong = disjunction(wrong, q.differs(kInitial, m.cleared[i], q.shown(i)));
  }
  q.script().ask(wrong);
  return {"they begin the same" + taken_over(m),
          Answer::unsat,
          {{{"at first"}, q.script().text()}},
          {}};
}

}  // namespace

Claim claim_clear(const MachineFormula& m, const Rtl& rtl) {
  if (m.clear_clocks == 0) return claim_initial(m, rtl);
  Question q(m, rtl, true);
  for (const Wire& given : m.clearing) {
    q.script().assume(equal(detail::symbol("in", given.field), given.code));
  }
  for (int i = 1; i < m.clear_clocks; ++i) q.clear_again();
  Expression wrong = any_fails(m.invariant_cleared);
  for (std::size_t i = 0; i < m.cleared.size(); ++i) {
    const Wire& w = m.cleared[i];
    if (w.field.unreset) continue;
    wrong = disjunction(wrong, q.differs(kAfter, w, q.after(i)));
    // A longer clear may take the model through states of its own.
    if (m.clear_clocks > 1) continue;
    wrong = disjunction(wrong, where_compared(w, negation(equal(m.after[i].code, w.code))));
  }
  q.script().ask(wrong);
  return {(m.clear_clocks == 1
               ? "a clear makes them the same"
               : fmt::format("{} clocks of a clear make them the same", m.clear_clocks)) +
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
      : question(m, rtl, false), claim{what, Answer::unsat, {}, {}} {
    question.assume_hypotheses();
    for (const Wire& w : m.inputs) claim.terms.push_back(w.code.text());
    for (const Wire& w : m.state) claim.terms.push_back(w.code.text());
    for (std::size_t i = 0; i < m.invariant_after.size(); ++i) {
      const Expression& kept = m.invariant_after[i].condition;
      claim.terms.push_back(question.script().define(broken_name(i), kept).text());
    }
  }
  Expression differs(const char* what, const Wire& w, const Expression& actual) {
    claim.terms.push_back(named("model", w.field) + what);
    claim.terms.push_back(named("rtl", w.field) + what);
    return question.differs(what, w, actual);
  }

  Question question;
  Claim claim;
};

}  // namespace

Claim claim_asserts(const MachineFormula& m, const Rtl& rtl) {
  OneClock clock("what the RTL asserts is so", m, rtl);
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
  OneClock clock("every clock keeps them the same", m, rtl);
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
    return Value{f, word(named("model", f) + what), word(named("rtl", f) + what)};
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
