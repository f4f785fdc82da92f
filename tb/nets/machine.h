// A golden model written out as gates: one clock from any state, under any inputs.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/core/design.h"
#include "model/core/fields.h"
#include "model/core/reset.h"
#include "model/core/synchronizer.h"
#include "tb/nets/number.h"

namespace cosim::nets {

/// A free value, and the code that it is the value of.
struct FreeCell {
  Number value;
  std::vector<Bit> code;
};

/// A field and its value, a code of the field's width.
struct Wire {
  Field field;
  std::vector<Bit> code;
  /// Of a register or an output: when it is compared; always where there is no condition.
  std::optional<Bit> when{};
};

/// A condition with a name.
struct Named {
  std::string name;
  Bit condition;
};

struct Machine {
  std::string design;
  std::vector<Parameter> parameters;
  bool clocks_are_inputs = false;  ///< there are several
  std::vector<Wire> inputs;        ///< free
  std::vector<Wire> state;         ///< free
  std::vector<Named>
      invariant;  ///< of the state before the clock: its fields are in range, and more
  std::vector<Named> invariant_after;  ///< the same of the state after it
  /// True of every state that can follow a reset, but not needed for RTL and model to be the same:
  /// of the state before the clock, after it, and after a reset.
  std::vector<Named> reached, reached_after, reached_in_reset;
  std::vector<Wire> registers;  ///< what the RTL's registers must hold before the clock
  /// Under an asynchronous reset, what they must show during it; else empty.
  std::vector<Wire> seen;
  std::vector<Wire> outputs;  ///< during it
  /// What the registers must hold after it, where synchronizers take the old value.
  std::vector<Wire> after;
  /// Of each register the bits that are the others there, by what synchronizers take; empty of a
  /// design without any. RTL knows nothing of it.
  std::vector<Wire> turned;
  std::vector<Wire> next;    ///< the state after it, with what they take
  std::vector<Named> cases;  ///< what may happen on a clock; each must be possible
  /// The ways through clock() of an exported model, where they are asked for; their words are those
  /// in its file.
  std::vector<Named> ways;
  std::vector<Named> legal;  ///< what is assumed of the inputs of a clock
  std::vector<Named> idle;   ///< the same of the inputs that the model says are legal always
  /// The inputs that reset the machine, with the values they have then, and on how many clocks they
  /// are given. None for a machine that begins at its initial values.
  std::vector<Wire> reset_inputs;
  int reset_clocks = 1;
  std::vector<Wire> begins;             ///< the state after that
  std::vector<Wire> reset_state;        ///< the registers after that
  std::vector<std::string> unobserved;  ///< registers and outputs that are not compared
  std::vector<Named> invariant_in_reset;
};

namespace detail {

/// A record of free values, which `make` gives of a field, and their wires.
template <class Record, class Fields, class Make>
Record free_record(const Fields& fields, Make make, std::vector<Wire>& wires) {
  Record r;
  for_each_cell<Record>([&](auto cell, std::size_t i) {
    if (fields[i].width == 0) return;
    const FreeCell free = make(fields[i]);
    cell(r) = free.value;
    wires.push_back({fields[i], free.code});
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

/// is_state() of every field, as a condition.
template <class Record, class Fields>
Condition<Number> in_range(const Record& r, const Fields& fields) {
  Condition<Number> all = true;
  for_each_cell<Record>([&](auto cell, std::size_t i) {
    if (fields[i].width == 0) return;
    const Number& v = cell(r);
    if (is_signed(fields[i])) {
      const Number most(ones(fields[i].width - 1));
      const bool one_more_below = fields[i].format == Format::twos_complement;
      all = all & !(v > most) & !(v < Number(0) - most - Number(one_more_below ? 1 : 0));
    } else {
      all = all & (low_bits(v, fields[i].width) == v);
    }
  });
  return all;
}

/// What a design states, or nothing.
template <class List>
std::vector<Named> named(const List& stated) {
  std::vector<Named> all;
  for (const auto& [name, condition] : stated) all.push_back({name, fact_of(condition)});
  return all;
}

/// The wires with the conditions under which they are compared.
template <class List>
std::vector<Wire> compared_when(std::vector<Wire> wires, const List& conditions) {
  for (const auto& [name, condition] : conditions) {
    for (Wire& w : wires) {
      if (std::string(w.field.name) == name) w.when = fact_of(condition);
    }
  }
  return wires;
}

/// The registers in state s.
template <class Design>
std::vector<Wire> registers_in(const typename Design::Params& p,
                               const typename Design::template State<Number>& s) {
  const auto fields = Design::template Registers<Word>::fields(p);
  return compared_when(wires(Design::registers(p, s), fields), registers_compared_of<Number>(p, s));
}

template <class Design>
std::vector<Named> whole_invariant(const typename Design::Params& p,
                                   const typename Design::template State<Number>& s) {
  const auto fields = Design::template State<Word>::fields(p);
  std::vector<Named> all{{"every field of the state is in range", fact_of(in_range(s, fields))}};
  for (auto& n : named(invariant_of<Number>(p, s))) all.push_back(std::move(n));
  return all;
}

}  // namespace detail

/// The ways through clock() in this state and with these inputs; none of a model that is not
/// exported.
template <class Design>
std::vector<Named> ways_of(const typename Design::Params& p,
                           const typename Design::template State<Number>& s,
                           const typename Design::template Inputs<Number>& in) {
  if constexpr (requires { Design::ways(p, s, in); }) {
    return detail::named(Design::ways(p, s, in));
  } else {
    return {};
  }
}

/// The machine of one design at the parameters p. free_state(field) and free_input(field) make a
/// FreeCell: of a state's field a number with a sign where it has one, of an input's its code.
template <class Design, class FreeState, class FreeInput>
Machine machine_of(const typename Design::Params& p, FreeState free_state, FreeInput free_input,
                   bool with_ways = false) {
  using detail::compared_when, detail::named, detail::wires;
  using State = typename Design::template State<Number>;
  using Inputs = typename Design::template Inputs<Number>;
  const auto state_fields = Design::template State<Word>::fields(p);
  const auto input_fields = Design::template Inputs<Word>::fields(p);
  const auto output_fields = Design::template Outputs<Word>::fields(p);

  Machine m;
  m.design = Design::name;
  m.clocks_are_inputs = clocks_of<Design> != 0;
  const auto parameters = Design::parameters(p);
  m.parameters.assign(parameters.begin(), parameters.end());
  const auto in = detail::free_record<Inputs>(input_fields, free_input, m.inputs);
  const auto s = detail::free_record<State>(state_fields, free_state, m.state);

  const auto seen = seen_state<Design, Number>(p, s, in);
  auto step = clock_of<Design, Number>(p, s, in);
  const auto after = Synchronizers<Design>(p).taken(p, s, in, step.state);
  m.invariant = detail::whole_invariant<Design>(p, s);
  m.invariant_after = detail::whole_invariant<Design>(p, after);
  m.reached = named(reached_of<Number>(p, s));
  m.reached_after = named(reached_of<Number>(p, after));
  m.registers = detail::registers_in<Design>(p, s);
  m.outputs = compared_when(wires(step.outputs, output_fields),
                            outputs_compared_of<Number>(p, seen, in, step.outputs));
  if (is_reset_asynchronous<Design>()) m.seen = detail::registers_in<Design>(p, seen);
  const auto register_fields = Design::template Registers<Word>::fields(p);
  auto held = Design::registers(p, step.state);
  m.after = compared_when(wires(held, register_fields), registers_compared_of<Number>(p, after));
  if constexpr (Synchronizers<Design>::any) {
    const auto taken = Design::registers(p, after);
    for_each_cell<decltype(held)>(
        [&](auto cell, std::size_t) { cell(held) = cell(held) ^ cell(taken); });
    m.turned = wires(held, register_fields);
  }
  m.next = wires(after, state_fields);
  m.cases = named(cases_of<Number>(p, s, in));
  if (with_ways) m.ways = ways_of<Design>(p, seen, in);
  m.legal = named(legal_of<Number>(p, s, in));
  if (!m.legal.empty()) m.idle = named(legal_of<Number>(p, s, idle_of<Design, Number>(p, s)));
  // Else nothing would show that the invariant can be met.
  if (m.cases.empty()) m.cases.push_back({"any clock", fact_of(Condition<Number>(true))});

  // Nor that what is not compared always is compared ever.
  for (const auto* wires : {&m.registers, &m.outputs}) {
    for (const Wire& w : *wires) {
      if (w.when && w.field.index <= 0)
        m.cases.push_back({std::string(w.field.name) + " is compared", *w.when});
    }
  }

  auto reset_state = reset_state_of<Design, Number>(p);
  m.begins = wires(reset_state, state_fields);
  for_each_cell<State>([&](auto cell, std::size_t i) {
    if (state_fields[i].unreset) cell(reset_state) = cell(s);
  });
  m.reset_state = detail::registers_in<Design>(p, reset_state);
  m.invariant_in_reset = detail::whole_invariant<Design>(p, reset_state);
  m.reached_in_reset = named(reached_of<Number>(p, reset_state));
  m.reset_clocks = reset_clocks_of<Design>();
  for (const char* pattern : Design::unobserved) m.unobserved.emplace_back(pattern);
  if constexpr (has_reset<Design>) {
    const auto reset = to_words(reset_inputs_of<Design>());
    const auto rest = to_words(rest_of<Design>());
    for (std::size_t i = 0; i < input_fields.size(); ++i) {
      const bool is_given = reset[i] != rest[i] || input_fields[i].edge != Edge::none;
      if (!is_given || input_fields[i].width == 0) continue;
      m.reset_inputs.push_back({input_fields[i], Number(reset[i]).code(input_fields[i].width)});
    }
  }
  return m;
}

}  // namespace cosim::nets
