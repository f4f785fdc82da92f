// Model and RTL in one graph with structural hashing, so that what both have alike is there once. A
// question is a miter: one bit that holds where anything differs. The step begins in any state, the
// RTL's flip-flops holding what the model says; the base case is the clocks of the reset, unrolled.
#include "tb/proof/net_questions.h"

#include <fmt/core.h>

#include "model/core/input_error.h"
#include "tb/proof/located.h"
#include "tb/proof/terms.h"

namespace cosim::proof {
namespace {

using nets::Bit;
using nets::no;
using nets::yes;
using Code = std::vector<Bit>;
using Machine = nets::MachineOf<nets::Number>;

// One graph with the model in it and, clock by clock, the RTL.
class NetQuestion {
 public:
  explicit NetQuestion(const nets::Model& model)
      : model_(model), questions_{model.graph, model.ports, {}, {}} {}
  NetQuestion(const nets::Model& model, const RtlNets& rtl) : NetQuestion(model) {
    rtl_ = &rtl;
    const Machine& m = model.machine;
    inputs_ = located(rtl, m.design, "input", m.inputs);
    outputs_ = located(rtl, m.design, "output", m.outputs);
    registers_ = located(rtl, m.design, "register", m.registers);
    std::vector<bool> is_named(rtl.cells().flip_flops.size());
    for (std::size_t i = 0; i < registers_.size(); ++i) {
      for (const std::size_t net : nets_of(registers_[i])) {
        const auto shown = rtl.shown(net);
        const std::string name = label_of(m.registers[i].field);
        if (!shown) {
          throw InputError(
              fmt::format("{}: the RTL's nets have no register {} of {} bits by itself", m.design,
                          name, m.registers[i].field.width));
        }
        if (is_named[*shown]) {
          throw InputError(
              fmt::format("{}: register {}: another field has its flip-flop", m.design, name));
        }
        is_named[*shown] = true;
      }
    }
  }

  nets::Graph& graph() { return questions_.graph; }

  // What the flip-flops may be before a clock.
  std::vector<Bit> anything() {
    std::vector<Bit> now(rtl_->cells().flip_flops.size());
    for (Bit& bit : now) bit = free();
    return now;
  }
  std::vector<Bit> at_first() {
    std::vector<Bit> now = anything();
    for (std::size_t i = 0; i < now.size(); ++i) {
      const char initial = rtl_->cells().flip_flops[i].initial;
      if (initial == '0' || initial == '1') now[i] = initial == '1' ? yes : no;
    }
    return now;
  }
  // What the model's registers say; anything where those mean nothing.
  std::vector<Bit> as_in_model() {
    std::vector<Bit> now = anything();
    for (std::size_t i = 0; i < registers_.size(); ++i) {
      const nets::Wire& w = model_.machine.registers[i];
      const auto nets = nets_of(registers_[i]);
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
    for (const auto& f : rtl_->cells().flip_flops) now.push_back(nets_[f.next]);
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
  Code output(std::size_t i) const { return bits_of(nets_of(outputs_[i])); }
  Code shown(std::size_t i) const { return bits_of(nets_of(registers_[i])); }
  Code after(std::size_t i) const {
    std::vector<std::size_t> next;
    for (const std::size_t net : nets_of(registers_[i])) {
      next.push_back(rtl_->cells().flip_flops[*rtl_->shown(net)].next);
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

  NetQuestions take() { return std::move(questions_); }

 private:
  Bit free() {
    const Bit bit = graph().input();
    questions_.inputs.push_back({fmt::format("free.{}", questions_.inputs.size()), bit});
    return bit;
  }
  std::vector<std::size_t> nets_of(const RtlCell& cell) const {
    std::vector<std::size_t> all;
    for (int i = 0; i < cell.width; ++i) all.push_back(rtl_->net(cell.wire, cell.low + i));
    return all;
  }
  Code bits_of(const std::vector<std::size_t>& nets) const {
    Code code;
    for (const std::size_t net : nets) code.push_back(nets_[net]);
    return code;
  }
  void clock(const std::vector<Bit>& flip_flops, const std::vector<nets::Wire>& inputs) {
    const nets::Cells& cells = rtl_->cells();
    std::vector<Bit> given(cells.nets.size());
    for (const auto* nets : {&cells.inputs, &cells.free}) {
      for (const std::size_t net : *nets) given[net] = free();
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const auto nets = nets_of(inputs_[i]);
      for (std::size_t b = 0; b < nets.size(); ++b) given[nets[b]] = inputs[i].code[b];
    }
    for (std::size_t i = 0; i < flip_flops.size(); ++i) {
      given[cells.flip_flops[i].now] = flip_flops[i];
    }
    nets_ = placed(graph(), cells, std::move(given));
  }

  const nets::Model& model_;
  const RtlNets* rtl_ = nullptr;
  std::vector<RtlCell> inputs_, outputs_, registers_;
  NetQuestions questions_;
  std::vector<Bit> nets_;  // of the RTL, on the clock that the question has come to
  Bit assumed_ = yes;
};

}  // namespace

NetQuestions nets_of_base_case(const nets::Model& model, const RtlNets& rtl) {
  const Machine& m = model.machine;
  NetQuestion q(model, rtl);
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
  return q.take();
}

NetQuestions nets_of_step(const nets::Model& model, const RtlNets& rtl) {
  const Machine& m = model.machine;
  NetQuestion q(model, rtl);
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
  return q.take();
}

NetQuestions nets_of_cases(const nets::Model& model) {
  NetQuestion q(model);
  q.assume_hypotheses();
  for (const nets::Named& n : model.machine.cases) q.ask(n.name, n.condition);
  return q.take();
}

NetQuestions nets_of_legal(const nets::Model& model) {
  NetQuestion q(model);
  q.assume(!q.any_fails(model.machine.invariant));
  q.ask("any state", q.any_fails(model.machine.idle));
  return q.take();
}

}  // namespace cosim::proof
