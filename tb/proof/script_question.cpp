#include "tb/proof/script_question.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/proof/arms.h"
#include "tb/proof/terms.h"

namespace cosim::proof {
namespace {

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

// Bits of a free symbol that a cell of a table is.
struct Given {
  Piece piece;
  Expression code;
};

}  // namespace

Question::Located Question::all_located(const std::vector<Wire>& registers) const {
  const MachineFormula& m = m_;
  const Rtl& rtl = rtl_;
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
Expression Question::held(const Wire& w) {
  if (!w.when) return w.code;
  const Expression any = script_.declare(term_of("any", w.field), w.code.sort());
  return {"ite", w.code.sort(), {*w.when, w.code, any}};
}

Question::Question(const MachineFormula& m, const Rtl& rtl, bool registers_free)
    : m_(m), rtl_(rtl), script_("QF_BV") {
  for (const Wire& w : m.inputs) script_.declare(w.code.text(), w.code.sort());
  for (const Wire& w : m.state) script_.declare(w.code.text(), w.code.sort());
  std::vector<Wire> registers = m.registers;
  for (Wire& w : registers) w.code = held(w);
  at_ = all_located(registers);
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

void Question::assume_hypotheses() {
  for (const auto* all : {&m_.invariant, &m_.legal}) {
    for (const Named& n : *all) script_.assume(n.condition);
  }
}

Expression Question::differs(const char* what, const Wire& expected, const Expression& actual,
                             bool by_arms) {
  const Expression e = script_.define(term_of("model", expected.field) + what, expected.code);
  const Expression a = script_.define(term_of("rtl", expected.field) + what, actual);
  // Those of an array are many, and each is little work.
  const bool is_easy = expected.field.width == 1 || expected.field.index >= 0;
  return where_compared(
      expected, by_arms && !is_easy ? differ(expected.code, actual, rtl_) : negation(equal(e, a)));
}

void Question::reset_again() {
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
  for (const Wire& given : m_.reset_inputs) {
    for (std::size_t i = 0; i < m_.inputs.size(); ++i) {
      if (label_of(m_.inputs[i].field) != label_of(given.field)) continue;
      script_.assume(equal(now(during(rtl_, at_.inputs[i])), given.code));
    }
  }
}

}  // namespace cosim::proof
