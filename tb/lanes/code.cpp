// A clock is four netlists one behind the other: what draws the inputs, the RTL, the model and, of
// jobs, what answers. Each is mapped to cells of three inputs by itself; the outputs of one are
// inputs of the next, and pins that are drawn as constants fold what they lead to. All bits that
// stay until the next clock are planes of the memory.
#include "tb/lanes/code.h"

#include <algorithm>
#include <map>
#include <span>

#include "model/core/input_error.h"
#include "tb/lanes/quiet.h"
#include "tb/proof/located.h"

namespace cosim::lanes {
namespace {

using nets::Bit;
using nets::Wire;

/// The cells of all, and where their values go.
class Maker {
 public:
  Maker(const nets::Played& played, const proof::RtlNets& rtl)
      : played_(played), machine_(played.model.machine), rtl_(rtl) {
    for (const auto& f : rtl.flip_flops()) {
      if (f.falls) throw InputError(machine_.design + ": a flip-flop of the falling edge");
    }
    lay_out();
  }

  Code take() {
    const nets::Draw& draw = played_.draw;
    make_clock(code_.clock, draw.clock, draw.answer ? &*draw.answer : nullptr);
    if (const auto quiet = quiet_of(draw)) {
      make_clock(code_.quiet, quiet->draw, &quiet->answer);
      code_.loud.compare(drawn("loud", code_.loud, quiet->loud).front(), zero);
      code_.has_quiet = true;
    }
    if (!draw.stretch.held.empty()) drawn("stretch", code_.stretch, draw.stretch);
    code_.reset_clocks = machine_.reset_clocks;
    code_.is_asked = draw.answer.has_value();
    const nets::Cells reset = rtl_cells(reset_inputs());
    const std::size_t pins = pins_of(reset_inputs()).size();
    store(code_.reset, rtl(code_.reset, reset, std::vector<Value>(pins, zero)), {});
    make_take_over(reset);
    return std::move(code_);
  }

 private:
  static void append(std::vector<Bit>& to, const std::vector<Bit>& bits) {
    to.insert(to.end(), bits.begin(), bits.end());
  }
  const std::vector<Wire>& registers() const {
    return machine_.seen.empty() ? machine_.registers : machine_.seen;
  }

  void lay_out() {
    Layout& l = code_.layout;
    const auto at_first = [&](bool is) {
      l.planes.push_back(is ? Layout::First::yes : Layout::First::no);
    };
    l.planes.resize(64 * played_.draw.seeds, Layout::First::seed);
    l.planes.resize(played_.draw.clock.held.size(), Layout::First::no);
    l.state = l.planes.size();
    for (std::size_t i = 0; i < machine_.state.size(); ++i) {
      for (int b = 0; b < machine_.state[i].field.width; ++b)
        at_first(bit(played_.reset_state[i], b));
    }
    flip_flops_ = l.planes.size();
    for (const auto& f : rtl_.flip_flops()) {
      if (f.initial == '0' || f.initial == '1') {
        at_first(f.initial == '1');
      } else {
        l.planes.push_back(Layout::First::anything);
      }
    }
    for (const auto& r : located(rtl_, machine_.design, "register", registers())) {
      registers_.push_back(r.bits);
      auto& planes = l.registers.emplace_back();
      for (const Bit net : registers_.back()) {
        const auto shown = rtl_.shown(net);
        planes.push_back(shown ? flip_flops_ + *shown : Layout::none);
      }
    }
    for (const auto& o : located(rtl_, machine_.design, "output", machine_.outputs)) {
      outputs_.push_back(o.bits);
    }
    bool any_left_out = false;
    for (const auto* wires : {&registers(), &machine_.outputs}) {
      for (const Wire& w : *wires) any_left_out = any_left_out || w.when;
    }
    if (any_left_out) l.counters = registers_.size() + outputs_.size();
  }

  // The model's cells. An input that is drawn as a constant is that one.
  nets::Cells model_cells(const std::vector<Bit>& inputs) const {
    nets::Graph graph;
    std::map<std::size_t, Bit> known;
    std::vector<Bit> in, out;
    for (const nets::Port& p : played_.model.ports) {
      const Bit drawn = in.size() < inputs.size() ? inputs[in.size()] : p.bit;
      in.push_back(graph.input());
      known[p.bit.gate()] = drawn.is_constant() ? drawn : in.back();
    }
    const auto gates = placed(graph, played_.model.graph, known);
    const auto add = [&](Bit bit) { out.push_back(nets::placed_at(gates, bit)); };
    for (const auto* wires : {&registers(), &machine_.outputs, &machine_.next, &machine_.turned}) {
      for (const Wire& w : *wires) std::for_each(w.code.begin(), w.code.end(), add);
    }
    for (const auto* wires : {&registers(), &machine_.outputs}) {
      for (const Wire& w : *wires) add(w.when.value_or(nets::yes));
    }
    return mapped("model", graph, in, out);
  }
  // The RTL's. Its inputs are those of the tables and then the flip-flops; its outputs what is
  // compared and then the flip-flops after the clock.
  nets::Cells rtl_cells(const std::vector<Bit>& inputs) const {
    nets::Graph graph;
    std::map<std::size_t, Bit> given;
    std::vector<Bit> in, out;
    for (const auto* all : {&rtl_.pins(), &rtl_.undefined()}) {
      for (const Bit net : *all) given[net.gate()] = nets::no;
    }
    const auto is_free = [&](Bit net) {
      in.push_back(graph.input());
      given[net.gate()] = in.back();
    };
    const auto pins = pins_of(inputs);
    for (const auto& i : located(rtl_, machine_.design, "input", machine_.inputs)) {
      for (const Bit net : i.bits) {
        is_free(net);
        const Bit is = pins.at(in.size() - 1);
        if (is.is_constant()) given[net.gate()] = is;
      }
    }
    for (const auto& f : rtl_.flip_flops()) is_free(f.now);
    const auto nets = placed(graph, rtl_.graph(), given);
    for (const auto* all : {&registers_, &outputs_}) {
      for (const auto& wire : *all) {
        for (const Bit net : wire) out.push_back(placed_at(nets, net));
      }
    }
    for (const auto& f : rtl_.flip_flops()) out.push_back(placed_at(nets, f.next));
    return mapped("rtl", graph, in, out);
  }
  // Of the model's inputs those that are pins.
  template <class T>
  std::vector<T> pins_of(const std::vector<T>& inputs) const {
    std::vector<T> pins;
    std::size_t at = 0;
    for (const Wire& w : machine_.inputs) {
      for (std::size_t b = 0; b < w.code.size(); ++b, ++at) {
        if (w.field.synchronizer == nullptr) pins.push_back(inputs[at]);
      }
    }
    return pins;
  }

  // The values of so many planes from one on.
  static void planes(Straight& code, std::vector<Value>& values, std::size_t first,
                     std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) values.push_back(code.plane(first + i));
  }
  std::size_t state_bits() const { return flip_flops_ - code_.layout.state; }
  std::size_t flip_flop_bits() const { return rtl_.flip_flops().size(); }

  // What the RTL gives where its pins have these values.
  std::vector<Value> rtl(Straight& code, const nets::Cells& cells, std::vector<Value> in) const {
    planes(code, in, flip_flops_, flip_flop_bits());
    return code.add(cells, in);
  }
  // The inputs that a step draws; what it goes on from then is stored.
  static std::vector<Value> drawn(const char* name, Straight& code, const nets::DrawStep& step) {
    std::vector<Value> held;
    planes(code, held, 0, step.held.size());
    std::vector<Bit> out = step.inputs;
    append(out, step.after);
    std::vector<Value> values = code.add(mapped(name, step.graph, step.held, out), held);
    for (std::size_t i = 0; i < step.after.size(); ++i) {
      if (step.after[i] != step.held[i]) code.store(i, values[step.inputs.size() + i]);
    }
    values.resize(step.inputs.size());
    return values;
  }
  // What the flip-flops hold after a clock that gave `out`, with the bits of registers turned over
  // that `turned` says, one behind the other; empty: none.
  void store(Straight& code, const std::vector<Value>& out, std::span<const Value> turned) {
    std::vector<Value> next(out.end() - static_cast<std::ptrdiff_t>(flip_flop_bits()), out.end());
    std::size_t at = 0;
    for (std::size_t r = 0; r < registers_.size() && !turned.empty(); ++r) {
      for (const Bit net : registers_[r]) {
        const Value is = turned[at++];
        if (is == zero) continue;
        const auto shown = rtl_.shown(net);
        if (!shown) {
          throw InputError(machine_.design + ": register " + label_of(registers()[r].field) +
                           " has no flip-flops of its own");
        }
        constexpr std::uint8_t differ = 0x66;
        next[*shown] = code.cell(differ, next[*shown], is, zero);
      }
    }
    for (std::size_t i = 0; i < next.size(); ++i) code.store(flip_flops_ + i, next[i]);
  }

  // `answer`: of jobs alone.
  void make_clock(Straight& code, const nets::DrawStep& draw, const nets::Answer* answer) {
    std::vector<Value> in = drawn("draw", code, draw);
    const auto actual = rtl(code, rtl_cells(draw.inputs), pins_of(in));
    planes(code, in, code_.layout.state, state_bits());
    const auto expected = code.add(model_cells(draw.inputs), in);

    std::size_t at = 0, when = when_first(expected), counter = 0;
    for (const auto* all : {&registers_, &outputs_}) {
      for (const auto& wire : *all) {
        for (std::size_t b = 0; b < wire.size(); ++b, ++at) {
          code.compare(expected[at], actual[at], expected[when]);
        }
        if (expected[when] != one) code.count_without(counter, expected[when]);
        ++counter;
        ++when;
      }
    }
    for (std::size_t i = 0; i < state_bits(); ++i)
      code.store(code_.layout.state + i, expected[at + i]);
    const std::size_t turned = when_first(expected) - at - state_bits();
    store(code, actual, std::span(expected).subspan(at + state_bits(), turned));
    if (answer != nullptr) answered(code, *answer, expected);
  }
  // What the model gives last are the conditions under which all is compared.
  std::size_t when_first(const std::vector<Value>& expected) const {
    return expected.size() - registers_.size() - outputs_.size();
  }
  // The outputs stand behind the registers.
  void answered(Straight& code, const nets::Answer& answer, const std::vector<Value>& expected) {
    std::size_t first = 0, count = 0;
    for (const auto& wire : registers_) first += wire.size();
    for (const auto& wire : outputs_) count += wire.size();
    std::vector<Value> held;
    const std::size_t planes_held = answer.held.size();
    planes(code, held, 0, planes_held);
    for (std::size_t i = 0; i < count; ++i) held.push_back(expected[first + i]);
    std::vector<Bit> in = answer.held, out = answer.after;
    append(in, answer.seen);
    out.push_back(answer.wrong);
    const auto after = code.add(mapped("answer", answer.graph, in, out), held);
    for (std::size_t i = 0; i < planes_held; ++i) {
      if (answer.after[i] != answer.held[i]) code.store(i, after[i]);
    }
    code.compare(after[planes_held], zero);
  }

  std::vector<Bit> reset_inputs() const {
    std::vector<Bit> in;
    for (std::size_t i = 0; i < machine_.inputs.size(); ++i) {
      for (std::size_t b = 0; b < machine_.inputs[i].code.size(); ++b) {
        in.push_back(bit(played_.reset_inputs[i], static_cast<int>(b)) ? nets::yes : nets::no);
      }
    }
    return in;
  }
  // Of a register's code the number that the model's state has by the same name.
  void make_take_over(const nets::Cells& reset) {
    Straight& code = code_.take_over;
    const auto held = rtl(code, reset, std::vector<Value>(pins_of(reset_inputs()).size(), zero));
    std::map<std::string, std::size_t> places;
    std::size_t at = 0;
    for (const Wire& w : machine_.state) {
      places[label_of(w.field)] = at;
      at += w.code.size();
    }
    at = 0;
    for (const Wire& w : machine_.registers) {
      const auto own = places.find(label_of(w.field));
      // Of one in ones' complement, 1 more where it is negative.
      Value carry = w.field.format == Format::ones_complement ? held[at + w.code.size() - 1] : zero;
      for (std::size_t b = 0; b < w.code.size(); ++b, ++at) {
        if (!w.field.unreset || own == places.end()) continue;
        constexpr std::uint8_t differ = 0x66, both = 0x88;
        code.store(code_.layout.state + own->second + b, code.cell(differ, held[at], carry, zero));
        carry = code.cell(both, held[at], carry, zero);
      }
    }
  }

  const nets::Played& played_;
  const nets::Machine& machine_;
  const proof::RtlNets& rtl_;
  Code code_;
  std::size_t flip_flops_ = 0;                   // their first plane
  std::vector<nets::Bits> registers_, outputs_;  // of the RTL
};

}  // namespace

Code code_of(const nets::Played& played, const proof::RtlNets& rtl) {
  return Maker(played, rtl).take();
}

}  // namespace cosim::lanes
