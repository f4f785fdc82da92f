// A golden model as formulas: one clock from any state, under any inputs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/core/design.h"
#include "model/core/fields.h"
#include "model/core/reset.h"
#include "tb/proof/bits.h"

namespace cosim::proof {

/// A field and its value, a code of the field's width.
struct Wire {
  Field field;
  Expression code;
  /// Of a register or an output: when it is compared; always where there is no condition.
  std::optional<Expression> when{};
};

/// What is wrong with a wire, where it is compared.
inline Expression where_compared(const Wire& w, const Expression& wrong) {
  return w.when ? conjunction(*w.when, wrong) : wrong;
}

/// A condition with a name.
struct Named {
  std::string name;
  Expression condition;
};

struct MachineFormula {
  std::string design;
  std::vector<Parameter> parameters;
  std::vector<Wire> inputs;  ///< free
  std::vector<Wire> state;   ///< free
  std::vector<Named>
      invariant;  ///< of the state before the clock: its fields are in range, and more
  std::vector<Named> invariant_after;  ///< the same of the state after it
  /// True of every state that can follow a clear, but not needed for RTL and model to be the same:
  /// of the state before the clock, after it, and after a clear.
  std::vector<Named> reached, reached_after, reached_cleared;
  std::vector<Wire> registers;  ///< what the RTL's registers must hold before the clock
  /// Under an asynchronous reset, what they must show during it; else empty.
  std::vector<Wire> seen;
  std::vector<Wire> outputs;  ///< during it
  std::vector<Wire> after;    ///< what the registers must hold after it
  std::vector<Named> parts;   ///< they cover all clocks and are easier one by one
  std::vector<Named> cases;   ///< what may happen on a clock; each must be possible
  std::vector<Named> legal;   ///< what is assumed of the inputs of a clock
  std::vector<Named> idle;    ///< the same of the inputs that the model says are legal always
  /// The inputs that clear the machine, with the values they have then, and on how many clocks they
  /// are given. None for a machine that begins at its initial values.
  std::vector<Wire> clearing;
  int clear_clocks = 1;
  std::vector<Wire> cleared;            ///< the registers after that
  std::vector<std::string> unobserved;  ///< registers that are not compared: nothing can be proved
  std::vector<Named> invariant_cleared;
};

namespace detail {

/// The name of a cell in a script: "store.3" of an element.
inline std::string term(const Field& f) {
  return f.index < 0 ? std::string(f.name) : std::string(f.name) + '.' + std::to_string(f.index);
}
inline Expression symbol(const char* kind, const Field& f) {
  return {std::string(kind) + '.' + term(f), bit_vector(f.width)};
}

/// A record of free symbols. A state's signed field is a number, an input's is a code.
template <class Record, class Fields>
Record symbols(const char* kind, const Fields& fields, bool codes) {
  Record r;
  for_each_cell<Record>([&](auto cell, std::size_t i) {
    if (fields[i].width == 0) return;
    const Expression e = symbol(kind, fields[i]);
    cell(r) = is_signed(fields[i]) && !codes ? Bits::signed_code(e, fields[i].width)
                                             : Bits::unsigned_code(e, fields[i].width);
  });
  return r;
}

template <class Record, class Fields>
std::vector<Wire> wires(const Record& r, const Fields& fields) {
  std::vector<Wire> all;
  for_each_cell<Record>([&](auto cell, std::size_t i) {
    if (fields[i].width != 0) all.push_back({fields[i], cell(r).code(fields[i].width)});
  });
  return all;
}

/// is_state() of every field, as a formula.
template <class Record, class Fields>
Truth in_range(const Record& r, const Fields& fields) {
  Truth all = true;
  for_each_cell<Record>([&](auto cell, std::size_t i) {
    if (fields[i].width == 0) return;
    const Bits& v = cell(r);
    if (is_signed(fields[i])) {
      const Bits most(ones(fields[i].width - 1));
      const bool one_more_below = fields[i].format == Format::twos_complement;
      all = all & !(v > most) & !(v < Bits(0) - most - Bits(one_more_below ? 1 : 0));
    } else {
      all = all & (low_bits(v, fields[i].width) == v);
    }
  });
  return all;
}

/// The wires with the conditions under which they are compared.
template <class List>
std::vector<Wire> compared_when(std::vector<Wire> wires, const List& conditions) {
  for (const auto& [name, condition] : conditions) {
    for (Wire& w : wires) {
      if (std::string(w.field.name) == name) w.when = condition.expression();
    }
  }
  return wires;
}

/// The registers in state s.
template <class Design>
std::vector<Wire> registers_in(const typename Design::Params& p,
                               const typename Design::template State<Bits>& s) {
  const auto fields = Design::template Registers<Word>::fields(p);
  return compared_when(wires(Design::registers(p, s), fields), registers_compared_of<Bits>(p, s));
}

template <class Design>
std::vector<Named> whole_invariant(const typename Design::Params& p,
                                   const typename Design::template State<Bits>& s) {
  std::vector<Named> all;
  const auto fields = Design::template State<Word>::fields(p);
  all.push_back({"every field of the state is in range", in_range(s, fields).expression()});
  for (const auto& [name, condition] : invariant_of<Bits>(p, s)) {
    all.push_back({name, condition.expression()});
  }
  return all;
}

/// What a design may state beside its invariant: reached(p, s).
template <class Design>
std::vector<Named> whole_reached(const typename Design::Params& p,
                                 const typename Design::template State<Bits>& s) {
  std::vector<Named> all;
  for (const auto& [name, condition] : reached_of<Bits>(p, s)) {
    all.push_back({name, condition.expression()});
  }
  return all;
}

}  // namespace detail

/// The formulas of one design at the parameters p.
template <class Design>
MachineFormula formula(const typename Design::Params& p) {
  using detail::wires;
  using State = typename Design::template State<Bits>;
  using Inputs = typename Design::template Inputs<Bits>;
  const auto state_fields = Design::template State<Word>::fields(p);
  const auto input_fields = Design::template Inputs<Word>::fields(p);
  const auto output_fields = Design::template Outputs<Word>::fields(p);

  MachineFormula m;
  m.design = Design::name;
  const auto parameters = parameters_of<Design>(p);
  m.parameters.assign(parameters.begin(), parameters.end());
  for (const Field& f : input_fields) {
    if (f.width != 0) m.inputs.push_back({f, detail::symbol("in", f)});
  }
  for (const Field& f : state_fields) {
    if (f.width != 0) m.state.push_back({f, detail::symbol("state", f)});
  }
  const auto s = detail::symbols<State>("state", state_fields, false);
  const auto in = detail::symbols<Inputs>("in", input_fields, true);

  const auto seen = seen_state<Design, Bits>(p, s, in);
  auto step = clocked<Design, Bits>(p, s, in);
  State::trim(p, step.state);
  m.invariant = detail::whole_invariant<Design>(p, s);
  m.invariant_after = detail::whole_invariant<Design>(p, step.state);
  m.reached = detail::whole_reached<Design>(p, s);
  m.reached_after = detail::whole_reached<Design>(p, step.state);
  m.registers = detail::registers_in<Design>(p, s);
  m.outputs = detail::compared_when(wires(step.outputs, output_fields),
                                    outputs_compared_of<Bits>(p, seen, in, step.outputs));
  if (is_reset_asynchronous<Design>()) m.seen = detail::registers_in<Design>(p, seen);
  m.after = detail::registers_in<Design>(p, step.state);
  for (const auto& [name, condition] : parts_of<Bits>(p, s)) {
    m.parts.push_back({name, condition.expression()});
  }
  for (const auto& [name, condition] : cases_of<Bits>(p, s, in)) {
    m.cases.push_back({name, condition.expression()});
  }
  for (const auto& [name, condition] : legal_of<Bits>(p, s, in)) {
    m.legal.push_back({name, condition.expression()});
  }
  if (!m.legal.empty()) {
    for (const auto& [name, condition] : legal_of<Bits>(p, s, idle_of<Design, Bits>(p, s))) {
      m.idle.push_back({name, condition.expression()});
    }
  }
  // Else nothing would show that the invariant can be met.
  if (m.cases.empty()) m.cases.push_back({"any clock", truth(true)});

  // Nor that what is not compared always is compared ever.
  for (const auto* wires : {&m.registers, &m.outputs}) {
    for (const Wire& w : *wires) {
      if (w.when && w.field.index <= 0)
        m.cases.push_back({std::string(w.field.name) + " is compared", *w.when});
    }
  }

  auto cleared = cleared_of<Design, Bits>();
  for_each_cell<State>([&](auto cell, std::size_t i) {
    if (state_fields[i].unreset) cell(cleared) = cell(s);
  });
  m.cleared = detail::registers_in<Design>(p, cleared);
  m.invariant_cleared = detail::whole_invariant<Design>(p, cleared);
  m.reached_cleared = detail::whole_reached<Design>(p, cleared);
  m.clear_clocks = clear_clocks_of<Design>();
  for (const char* pattern : unobserved_of<Design>()) m.unobserved.emplace_back(pattern);
  if constexpr (has_clear<Design>) {
    const auto clear = to_words(Design::clear());
    const auto rest = to_words(rest_of<Design>());
    for (std::size_t i = 0; i < input_fields.size(); ++i) {
      if (clear[i] == rest[i] || input_fields[i].width == 0) continue;
      m.clearing.push_back({input_fields[i], Bits(clear[i]).code(input_fields[i].width)});
    }
  }
  return m;
}

}  // namespace cosim::proof
