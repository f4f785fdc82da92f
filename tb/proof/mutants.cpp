#include "tb/proof/mutants.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <regex>

namespace cosim::proof {
namespace {

constexpr const char* kSelect = "mutsel";
constexpr int kSelectBits = 16;

std::string net(const Field& f) { return std::string(f.name) + "_q"; }

// The same symbols on the clock after.
std::string on_next_clock(const std::string& text) {
  static const std::regex symbol(R"(\|([^|]*)\|)");
  return std::regex_replace(text, symbol, "|$1'|");
}
Expression on_next_clock(const Expression& e) {
  if (e.parts().empty()) return {on_next_clock(e.text()), e.sort()};
  std::vector<Expression> parts;
  for (const Expression& p : e.parts()) parts.push_back(on_next_clock(p));
  return {e.text(), e.sort(), parts};
}

// The inputs are the model's, mutsel is the number, the flip-flops are free; two clocks of it.
Script two_clocks(const MachineFormula& m, const Rtl& rtl, unsigned number) {
  Script script("QF_BV");
  for (const Wire& w : m.inputs) script.declare(w.code.text(), w.code.sort());
  for (const Wire& w : m.state) script.declare(w.code.text(), w.code.sort());
  std::vector<std::optional<Expression>> given(rtl.free().size());
  const auto give = [&](const std::string& name, const Expression& code, int low) {
    for (const std::size_t i : rtl.pieces(name)) {
      low -= rtl.free()[i].width;
      given[i] = cut(code, low, rtl.free()[i].width);
    }
  };
  for (const Wire& w : m.inputs) give(w.field.name, w.code, w.field.width);
  give(kSelect, Bits(static_cast<Word>(number)).code(kSelectBits), kSelectBits);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Rtl::Free& f = rtl.free()[i];
    const std::string sort = f.is_bool ? boolean : bit_vector(f.width);
    if (given[i] && f.after.empty()) {
      script.define(f.symbol, as_sort(*given[i], sort));
    } else {
      script.declare(f.symbol, sort);
    }
  }
  script.add(rtl.definitions());
  const std::vector<std::size_t> select = rtl.pieces(kSelect);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Rtl::Free& f = rtl.free()[i];
    const std::string sort = f.is_bool ? boolean : bit_vector(f.width);
    const bool selects = std::find(select.begin(), select.end(), i) != select.end();
    if (!f.after.empty() || selects) {
      script.define(on_next_clock(f.symbol), {selects ? f.symbol : f.after, sort});
    } else {
      script.declare(on_next_clock(f.symbol), sort);
    }
  }
  script.add(on_next_clock(rtl.definitions()));
  return script;
}

Expression differ(const Expression& a, const Expression& b) { return negation(equal(a, b)); }

Expression after_differs(const std::vector<Wire>& expected, const Rtl& rtl) {
  Expression any = truth(false);
  for (const Wire& w : expected) {
    any = disjunction(any, differ(on_next_clock(rtl.wire(net(w.field))), w.code));
  }
  return any;
}

Claim asked(const std::string& what, unsigned number, Script script, const Expression& wrong) {
  script.ask(wrong);
  return {what, Answer::unsat, {{{fmt::format("mutant {}", number)}, script.text()}}, {}};
}

}  // namespace

Claim mutant_clear(const MachineFormula& m, const Rtl& rtl, unsigned number) {
  Script script = two_clocks(m, rtl, number);
  for (const Wire& w : m.clearing) {
    script.assume(equal(detail::symbol("in", w.field), w.code));
  }
  return asked("a clear makes them the same", number, script, after_differs(m.cleared, rtl));
}

Claim mutant_step(const MachineFormula& m, const Rtl& rtl, unsigned number) {
  Script script = two_clocks(m, rtl, number);
  for (const Named& n : m.invariant) script.assume(n.condition);
  for (const Wire& w : m.registers) script.assume(equal(rtl.wire(net(w.field)), w.code));
  Expression wrong = after_differs(m.after, rtl);
  for (const Wire& w : m.outputs) {
    wrong = disjunction(wrong, differ(rtl.wire(w.field.name), w.code));
  }
  return asked("every clock keeps them the same", number, script, wrong);
}

}  // namespace cosim::proof
