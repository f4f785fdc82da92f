#include "tb/proof/claims.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/proof/counterexample.h"
#include "tb/proof/located.h"

namespace cosim::proof {
namespace {

using nets::Bit;
using nets::no;
using nets::yes;
using Code = std::vector<Bit>;
using nets::Machine;

// One graph with the model in it and, clock by clock, the RTL.
class Question {
 public:
  explicit Question(const nets::Model& model)
      : model_(model), questions_{model.graph, model.ports, {}, {}} {}
  Question(const nets::Model& model, const RtlNets& rtl) : Question(model) {
    rtl_ = &rtl;
    const Machine& m = model.machine;
    inputs_ = located(rtl, m.design, "input", m.inputs);
    outputs_ = located(rtl, m.design, "output", m.outputs);
    registers_ = located(rtl, m.design, "register", m.registers);
    std::vector<bool> is_named(rtl.flip_flops().size());
    for (std::size_t i = 0; i < registers_.size(); ++i) {
      for (const Bit net : registers_[i].bits) {
        const auto shown = rtl.shown(net);
        const std::string name = label_of(m.registers[i].field);
        if (!shown) {
          throw InputError(
              fmt::format("{}: the RTL's netlist has no register {} of {} bits of its own",
                          m.design, name, m.registers[i].field.width));
        }
        if (is_named[*shown]) {
          throw InputError(
              fmt::format("{}: register {}: another field has its flip-flop", m.design, name));
        }
        is_named[*shown] = true;
      }
    }
    if (std::ranges::find(is_named, false) != is_named.end()) {
      throw InputError(m.design + ": the RTL has a register that the model does not have");
    }
    require_ports("input", rtl.inputs(), inputs_);
    require_ports("output", rtl.outputs(), outputs_);
  }

  nets::Graph& graph() { return questions_.graph; }

  // What the flip-flops may be before a clock.
  std::vector<Bit> anything() {
    std::vector<Bit> now(rtl_->flip_flops().size());
    for (Bit& bit : now) bit = free();
    return now;
  }
  std::vector<Bit> at_first() {
    std::vector<Bit> now = anything();
    for (std::size_t i = 0; i < now.size(); ++i) {
      const char initial = rtl_->flip_flops()[i].initial;
      if (initial == '0' || initial == '1') now[i] = initial == '1' ? yes : no;
    }
    return now;
  }
  // What the model's registers say; anything where those mean nothing.
  std::vector<Bit> as_in_model() {
    std::vector<Bit> now = anything();
    for (std::size_t i = 0; i < registers_.size(); ++i) {
      const nets::Wire& w = model_.machine.registers[i];
      const nets::Bits& nets = registers_[i].bits;
      for (std::size_t b = 0; b < nets.size(); ++b) {
        Bit& bit = now[*rtl_->shown(nets[b])];
        bit = w.when ? graph().mux(*w.when, w.code[b], bit) : w.code[b];
      }
    }
    return now;
  }

  // Puts a clock of the RTL into the graph, from these flip-flops, under the model's inputs.
  void clock(const std::vector<Bit>& flip_flops) { clock(flip_flops, model_.machine.inputs); }
  // One more clock of a reset: of its inputs those that reset are the same, the others free.
  void reset_again() {
    std::vector<Bit> now;
    for (const auto& f : rtl_->flip_flops()) now.push_back(at(f.next));
    std::vector<nets::Wire> inputs = model_.machine.inputs;
    for (nets::Wire& w : inputs) {
      for (Bit& bit : w.code) bit = free();
      for (const nets::Wire& given : model_.machine.reset_inputs) {
        if (label_of(given.field) == label_of(w.field)) w.code = given.code;
      }
    }
    clock(now, inputs);
  }
  // What the RTL gives for output number i during the clock, and register number i during and after
  // it.
  Code output(std::size_t i) const { return bits_of(outputs_[i].bits); }
  Code shown(std::size_t i) const { return bits_of(registers_[i].bits); }
  Code after(std::size_t i) const {
    nets::Bits next;
    for (const Bit net : registers_[i].bits) {
      next.push_back(rtl_->flip_flops()[*rtl_->shown(net)].next);
    }
    return bits_of(next);
  }

  Bit any_fails(const std::vector<nets::Named>& all) {
    Bit any = no;
    for (const nets::Named& n : all) any = graph().or_of(any, !n.condition);
    return any;
  }
  // Of what is assumed, and of the state and inputs.
  void assume(Bit condition) { assumed_ = graph().and_of(assumed_, condition); }
  void assume_hypotheses() {
    assume(!any_fails(model_.machine.invariant));
    assume(!any_fails(model_.machine.legal));
  }
  void ask(const std::string& what, Bit bit) {
    questions_.asked.push_back({what, graph().and_of(assumed_, bit)});
  }
  // Names a code for the counterexample.
  void show(const std::string& term, const Code& code) { questions_.terms[term] = code; }

  Questions take() { return std::move(questions_); }

 private:
  // An error where the RTL has a port, or a bit of one, that the table does not name.
  void require_ports(const char* what, const std::vector<std::string>& ports,
                     const std::vector<RtlCell>& cells) const {
    const std::string& design = model_.machine.design;
    for (const std::string& port : ports) {
      std::vector<bool> named(static_cast<std::size_t>(rtl_->width(port)));
      for (const RtlCell& c : cells) {
        for (std::size_t i = 0; port == c.wire && i < c.bits.size(); ++i) {
          named[static_cast<std::size_t>(c.low) + i] = true;
        }
      }
      const auto open = std::ranges::find(named, false);
      if (open == named.end()) continue;
      if (std::ranges::find(named, true) == named.end()) {
        throw InputError(fmt::format("{}: the RTL has an {} {} that the model does not have",
                                     design, what, port));
      }
      throw InputError(fmt::format("{}: {} {}: no field has its bit {}", design, what, port,
                                   open - named.begin()));
    }
  }
  Bit free() {
    const Bit bit = graph().input();
    questions_.inputs.push_back({fmt::format("free.{}", questions_.inputs.size()), bit});
    return bit;
  }
  Bit at(Bit net) const { return nets::placed_at(nets_, net); }
  Code bits_of(const nets::Bits& nets) const {
    Code code;
    for (const Bit net : nets) code.push_back(at(net));
    return code;
  }
  void clock(const std::vector<Bit>& flip_flops, const std::vector<nets::Wire>& inputs) {
    std::map<std::size_t, Bit> given;
    for (const auto* all : {&rtl_->pins(), &rtl_->undefined()}) {
      for (const Bit pin : *all) given[pin.gate()] = free();
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const nets::Bits& pins = inputs_[i].bits;
      for (std::size_t b = 0; b < pins.size(); ++b) given[pins[b].gate()] = inputs[i].code[b];
    }
    for (std::size_t i = 0; i < flip_flops.size(); ++i) {
      given[rtl_->flip_flops()[i].now.gate()] = flip_flops[i];
    }
    nets_ = placed(graph(), rtl_->graph(), given);
  }

  const nets::Model& model_;
  const RtlNets* rtl_ = nullptr;
  std::vector<RtlCell> inputs_, outputs_, registers_;
  Questions questions_;
  nets::Bits nets_;  // by gate of the RTL, on the clock that the question has come to
  Bit assumed_ = yes;
};

// ", but for a, b": what the model takes over from the RTL, of an array once, not each element.
std::string taken_over(const Machine& m) {
  std::string text;
  for (const nets::Wire& w : m.reset_state) {
    if (!w.field.unreset || w.field.index > 0) continue;
    text += std::string(text.empty() ? ", but for " : ", ") + w.field.name;
  }
  return text;
}

}  // namespace

Claim claim_base_case(const nets::Model& model, const RtlNets& rtl) {
  const Machine& m = model.machine;
  Question q(model, rtl);
  Bit wrong = q.any_fails(m.invariant_in_reset);
  const bool resets = m.reset_clocks > 0;
  q.clock(resets ? q.anything() : q.at_first());
  for (const nets::Wire& given : m.reset_inputs) {
    for (const nets::Wire& w : m.inputs) {
      if (label_of(w.field) == label_of(given.field))
        q.assume(!q.graph().differ(w.code, given.code));
    }
  }
  for (int i = 1; i < m.reset_clocks; ++i) q.reset_again();
  for (std::size_t i = 0; i < m.reset_state.size(); ++i) {
    const nets::Wire& w = m.reset_state[i];
    if (w.field.unreset) continue;
    const Code held = resets ? q.after(i) : q.shown(i);
    wrong = q.graph().or_of(wrong, where_compared(q.graph(), w, q.graph().differ(w.code, held)));
    // A longer reset may take the model through states of its own.
    if (m.reset_clocks != 1) continue;
    wrong = q.graph().or_of(
        wrong, where_compared(q.graph(), w, q.graph().differ(m.after[i].code, w.code)));
  }
  q.ask(resets ? "any clock" : "at first", wrong);
  const std::string what =
      !resets ? "they begin the same"
      : m.reset_clocks == 1
          ? "a reset makes them the same"
          : fmt::format("{} clocks of a reset make them the same", m.reset_clocks);
  return {"base case: " + what + taken_over(m), Answer::unsat, q.take()};
}

Claim claim_step(const nets::Model& model, const RtlNets& rtl) {
  const Machine& m = model.machine;
  Question q(model, rtl);
  q.assume_hypotheses();
  q.clock(q.as_in_model());
  for (const nets::Wire& w : m.inputs) q.show(term_of("in", w.field), w.code);
  for (const nets::Wire& w : m.state) q.show(term_of("state", w.field), w.code);
  for (std::size_t i = 0; i < m.invariant_after.size(); ++i) {
    q.show(term_of_invariant(i), {m.invariant_after[i].condition});
  }
  Bit wrong = q.any_fails(m.invariant_after);
  const auto compare = [&](const char* what, const nets::Wire& w, const Code& actual) {
    q.show(term_of("model", w.field) + what, w.code);
    q.show(term_of("rtl", w.field) + what, actual);
    wrong = q.graph().or_of(wrong, where_compared(q.graph(), w, q.graph().differ(w.code, actual)));
  };
  for (std::size_t i = 0; i < m.after.size(); ++i) compare(kAfter, m.after[i], q.after(i));
  for (std::size_t i = 0; i < m.seen.size(); ++i) compare(kSeen, m.seen[i], q.shown(i));
  for (std::size_t i = 0; i < m.outputs.size(); ++i) compare(kOutput, m.outputs[i], q.output(i));
  q.ask("any clock", wrong);
  return {"inductive step: every clock keeps them the same", Answer::unsat, q.take()};
}

Claim claim_cases(const nets::Model& model) {
  const auto& cases = model.machine.cases;
  Question q(model);
  q.assume_hypotheses();
  for (const nets::Named& n : cases) q.ask(n.name, n.condition);
  const std::string what = cases.size() == 1
                               ? cases.front().name + " is possible"
                               : fmt::format("each of {} cases is possible", cases.size());
  return {"vacuity check: " + what, Answer::sat, q.take()};
}

Claim claim_legal(const nets::Model& model) {
  Question q(model);
  q.assume(!q.any_fails(model.machine.invariant));
  q.ask("any state", q.any_fails(model.machine.idle));
  return {"legal inputs in every state", Answer::unsat, q.take()};
}

std::vector<Claim> claims_of(const nets::Model& model, const Source& source) {
  const Machine& m = model.machine;
  const RtlNets rtl(source);
  std::vector<Claim> all;
  if (m.unobserved.empty()) {
    all.push_back(claim_base_case(model, rtl));
    all.push_back(claim_step(model, rtl));
  } else {
    all.push_back({"from reset: always the same"});
  }
  for (Claim& claim : all) claim.from_reset = Happens::differ;
  all.push_back(claim_cases(model));
  if (!m.legal.empty()) {
    all.push_back(claim_legal(model));
    all.back().from_reset = Happens::stuck;
  }
  if (rtl.asserts()) {
    all.push_back({"what the RTL asserts is so"});
    all.back().from_reset = Happens::assertion;
  }
  return all;
}

}  // namespace cosim::proof
