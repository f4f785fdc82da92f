// The RTL is placed in one graph again for each mutant, its number a constant. Constants are folded
// and equal gates are there once (structural hashing), so that each is only what its fault changes;
// many are decided by that alone. What is left of all is one question for an engine.
#include "tb/proof/mutant_questions.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <utility>

#include "tb/proof/counterexample.h"
#include "tb/proof/located.h"

namespace cosim::proof {
namespace {

using nets::Bit;
using nets::no;
using nets::yes;
using Row = std::vector<Bit>;
using Known = MutantQuestions::Known;

// The model, and the RTL with any of its mutants.
class Maker {
 public:
  Maker(const nets::Model& model, const RtlNets& rtl)
      : machine_(model.machine), rtl_(rtl), q_{model.graph, model.ports, {}, {}} {
    inputs_ = located(rtl, machine_.design, "input", machine_.inputs);
    registers_ = located(rtl, machine_.design, "register", machine_.registers);
    outputs_ = located(rtl, machine_.design, "output", machine_.outputs);
    for (const auto* all : {&rtl.pins(), &rtl.undefined()}) {
      for (const Bit pin : *all) anything_[pin.gate()] = free_bit();
    }
    for (const auto& f : rtl.flip_flops()) anything_[f.now.gate()] = free_bit();
    for (const auto* all : {&machine_.invariant, &machine_.reached, &machine_.legal}) {
      for (const nets::Named& n : *all) assumed_ = graph().and_of(assumed_, n.condition);
    }
    original_ = step_of(0);
  }

  Known ask(unsigned number) {
    const Step with = step_of(number);
    if (with.clocks != original_.clocks) return Known::other;
    const Bit wrong = graph().or_of(differ(with), not_reset(number));
    if (wrong == no) return Known::same;
    if (wrong == yes) return Known::other;
    q_.asked.push_back({fmt::format("mutant {}", number), wrong});
    return Known::asked;
  }
  // The step alone, with what a counterexample shows.
  void ask_and_show(unsigned number) {
    const Step with = step_of(number);
    q_.asked.push_back({fmt::format("mutant {}", number), differ(with)});
    for (const nets::Wire& w : machine_.inputs) q_.terms[term_of("in", w.field)] = w.code;
    for (const nets::Wire& w : machine_.state) q_.terms[term_of("state", w.field)] = w.code;
    const auto show = [&](const char* what, const std::vector<nets::Wire>& wires,
                          const std::vector<Row>& a, const std::vector<Row>& b) {
      for (std::size_t i = 0; i < wires.size(); ++i) {
        q_.terms[term_of("model", wires[i].field) + what] = a[i];
        q_.terms[term_of("rtl", wires[i].field) + what] = b[i];
      }
    };
    show(kAfter, machine_.after, original_.after, with.after);
    show(kOutput, machine_.outputs, original_.outputs, with.outputs);
  }
  Questions take() { return std::move(q_); }

 private:
  // A clock of the RTL from the states that the model has.
  struct Step {
    Bit given = yes;  // that registers hold what the model's hold, where flip-flops are not they
    std::vector<Row> after, outputs;
    Row clocks;
  };

  nets::Graph& graph() { return q_.graph; }
  // Whether the step of a mutant is another one, from the states that are assumed.
  Bit differ(const Step& with) {
    Bit wrong = no;
    const auto compare = [&](const std::vector<nets::Wire>& wires, const std::vector<Row>& a,
                             const std::vector<Row>& b) {
      for (std::size_t i = 0; i < wires.size(); ++i) {
        wrong = graph().or_of(wrong, where_compared(graph(), wires[i], graph().differ(a[i], b[i])));
      }
    };
    compare(machine_.after, original_.after, with.after);
    compare(machine_.outputs, original_.outputs, with.outputs);
    return graph().and_of(wrong,
                          graph().and_of(assumed_, graph().and_of(original_.given, with.given)));
  }
  Bit free_bit() {
    const Bit bit = graph().input();
    q_.inputs.push_back({fmt::format("free.{}", q_.inputs.size()), bit});
    return bit;
  }

  // By gate: flip-flops hold `held`; inputs are the model's, or free.
  Row placed(unsigned number, const Row& held, bool free_inputs,
             const std::vector<nets::Wire>& reset_inputs = {}) {
    std::map<std::size_t, Bit> given = anything_;
    for (int i = 0; i < rtl_.width("mutsel"); ++i) {
      given[rtl_.net("mutsel", i).gate()] = nets::constant((number >> i & 1U) != 0);
    }
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      const nets::Wire& own = machine_.inputs[i];
      const Row* code = free_inputs ? nullptr : &own.code;
      for (const nets::Wire& w : reset_inputs) {
        if (label_of(w.field) == label_of(own.field)) code = &w.code;
      }
      const Row& pins = inputs_[i].bits;
      for (std::size_t b = 0; code != nullptr && b < pins.size(); ++b) {
        given[pins[b].gate()] = (*code)[b];
      }
    }
    for (std::size_t i = 0; i < held.size(); ++i) {
      given[rtl_.flip_flops()[i].now.gate()] = held[i];
    }
    return nets::placed(graph(), rtl_.graph(), given);
  }
  Row held_at_random() const {
    Row all;
    for (const auto& f : rtl_.flip_flops()) all.push_back(anything_.at(f.now.gate()));
    return all;
  }
  Row next_of(const Row& nets) const {
    Row all;
    for (const auto& f : rtl_.flip_flops()) all.push_back(placed_at(nets, f.next));
    return all;
  }
  static std::vector<Row> in(const Row& nets, const std::vector<RtlCell>& of) {
    std::vector<Row> all;
    for (const RtlCell& cell : of) {
      Row bits;
      for (const Bit net : cell.bits) bits.push_back(placed_at(nets, net));
      all.push_back(std::move(bits));
    }
    return all;
  }

  Step step_of(unsigned number) {
    Step step;
    Row held = held_at_random();
    // A net that is a flip-flop, while no reset is given that does not wait for a clock, gives it
    // its value; of any other that is assumed.
    const Row nets = placed(number, held, false, without_reset());
    for (std::size_t i = 0; i < registers_.size(); ++i) {
      const nets::Wire& w = machine_.registers[i];
      for (std::size_t b = 0; b < registers_[i].bits.size(); ++b) {
        const auto own = std::ranges::find(held, placed_at(nets, registers_[i].bits[b]));
        if (own == held.end()) continue;
        *own = w.when ? graph().mux(*w.when, w.code[b], *own) : w.code[b];
      }
    }
    const Row now = placed(number, held, false);
    for (std::size_t i = 0; i < registers_.size(); ++i) {
      const nets::Wire& w = machine_.seen.empty() ? machine_.registers[i] : machine_.seen[i];
      for (std::size_t b = 0; b < registers_[i].bits.size(); ++b) {
        const Bit wrong = graph().xor_of(placed_at(now, registers_[i].bits[b]), w.code[b]);
        step.given = graph().and_of(step.given, !where_compared(graph(), w, wrong));
      }
    }
    step.outputs = in(now, outputs_);
    step.after = in(placed(number, next_of(now), true), registers_);
    for (const auto& f : rtl_.flip_flops()) {
      if (f.clock) step.clocks.push_back(placed_at(now, *f.clock));
    }
    return step;
  }

  // The inputs that reset the machine at once, at rest; none where the reset waits for a clock.
  std::vector<nets::Wire> without_reset() const {
    std::vector<nets::Wire> all;
    for (nets::Wire w : machine_.seen.empty() ? std::vector<nets::Wire>{} : machine_.reset_inputs) {
      for (Bit& bit : w.code) bit = !bit;
      all.push_back(std::move(w));
    }
    return all;
  }

  // After a clock that resets, whatever the flip-flops held.
  Bit not_reset(unsigned number) {
    const Row now = placed(number, held_at_random(), false, machine_.reset_inputs);
    const auto after = in(placed(number, next_of(now), true), registers_);
    Bit wrong = no;
    for (std::size_t i = 0; i < after.size(); ++i) {
      const nets::Wire& w = machine_.reset_state[i];
      if (w.field.unreset) continue;  // whatever it holds, the model takes it over
      wrong = graph().or_of(wrong, where_compared(graph(), w, graph().differ(after[i], w.code)));
    }
    return wrong;
  }

  const nets::Machine& machine_;
  const RtlNets& rtl_;
  Questions q_;
  std::vector<RtlCell> inputs_, registers_, outputs_;
  std::map<std::size_t, Bit> anything_;  // by gate, of inputs and flip-flops
  Bit assumed_ = yes;
  Step original_;
};

}  // namespace

Claim reached_claim(const nets::Model& model) {
  const auto& m = model.machine;
  Questions q{model.graph, model.ports, {}, {}};
  Bit assumed = yes, wrong = no;
  for (const auto* all : {&m.invariant, &m.reached, &m.legal}) {
    for (const nets::Named& n : *all) assumed = q.graph.and_of(assumed, n.condition);
  }
  for (const auto* all :
       {&m.invariant_after, &m.reached_after, &m.invariant_in_reset, &m.reached_in_reset}) {
    for (const nets::Named& n : *all) wrong = q.graph.or_of(wrong, !n.condition);
  }
  q.asked.push_back({"any clock", q.graph.and_of(assumed, wrong)});
  return {"what is reached stays so", Answer::unsat, std::move(q)};
}

MutantQuestions questions_of_mutants(const nets::Model& model, const RtlNets& rtl,
                                     const std::vector<unsigned>& numbers) {
  Maker maker(model, rtl);
  MutantQuestions all;
  for (const unsigned number : numbers) all.known.push_back(maker.ask(number));
  all.questions = maker.take();
  return all;
}

Questions question_of_mutant(const nets::Model& model, const RtlNets& rtl, unsigned number) {
  Maker maker(model, rtl);
  maker.ask_and_show(number);
  return maker.take();
}

}  // namespace cosim::proof
