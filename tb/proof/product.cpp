// The product of the two machines. The clocks of the reset are not part of it: they are written out
// in front of it (unrolled), from any state of the RTL that its initial values allow, and what
// comes of them is what its registers begin as. A bit that is the same whatever was before is a
// constant there; any other is chosen on the first clock.
#include "tb/proof/product.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "model/core/input_error.h"
#include "tb/proof/located.h"

namespace cosim::proof {
namespace {

using nets::Bit;
using nets::no;
using nets::yes;
using Code = std::vector<Bit>;

class ProductMaker {
 public:
  ProductMaker(const nets::Model& model, const RtlNets& rtl,
               const std::map<std::string, Word>& tied, const std::vector<Watched>& watched)
      : m_(model.machine),
        rtl_(rtl),
        watched_(watched),
        graph_(model.graph),
        free_(model.graph.inputs()) {
    inputs_ = located(rtl, m_.design, "input", m_.inputs);
    registers_ = located(rtl, m_.design, "register", m_.registers);
    outputs_ = located(rtl, m_.design, "output", m_.outputs);
    for (const auto& [port, value] : tied) {
      for (int b = 0; b < rtl.width(port); ++b) {
        tied_[rtl.net(port, b).gate()] = nets::constant(cosim::bit(value, b));
      }
    }
  }

  Product make() {
    const Code first = after_reset();
    // The clock that all is asked of.
    Code now;
    for (std::size_t i = 0; i < first.size(); ++i) now.push_back(graph_.input());
    const Code nets = clock(now, codes_of(m_.inputs));
    for (std::size_t i = 0; i < now.size(); ++i) {
      registers_now_.push_back({now[i], first[i], placed_at(nets, rtl_.flip_flops()[i].next)});
    }
    turn();
    add_state(first);
    ask_all(nets);
    for (const Watched& one : watched_) asked_[Happens::watched].emplace_back("", seen(one, nets));
    translate();
    return std::move(product_);
  }

 private:
  struct Register {
    Bit now, first, next;
  };
  using Asked = std::vector<std::pair<std::string, Bit>>;

  static std::vector<Code> codes_of(const std::vector<nets::Wire>& wires) {
    std::vector<Code> all;
    for (const nets::Wire& w : wires) all.push_back(w.code);
    return all;
  }

  // What each gate of the RTL is.
  Code clock(const Code& flip_flops, const std::vector<Code>& inputs) {
    std::map<std::size_t, Bit> given = tied_;
    for (const auto* all : {&rtl_.pins(), &rtl_.undefined()}) {
      for (const Bit pin : *all) {
        if (!given.contains(pin.gate())) given[pin.gate()] = graph_.input();
      }
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const Code& pins = inputs_[i].bits;
      for (std::size_t b = 0; b < pins.size(); ++b) given[pins[b].gate()] = inputs[i][b];
    }
    for (std::size_t i = 0; i < flip_flops.size(); ++i) {
      given[rtl_.flip_flops()[i].now.gate()] = flip_flops[i];
    }
    return placed(graph_, rtl_.graph(), given);
  }

  // What synchronizers take. RTL with mutants takes the old value: they may stand between a
  // register and its net.
  void turn() {
    for (std::size_t i = 0; i < m_.turned.size() && !has_mutants(); ++i) {
      for (std::size_t b = 0; b < registers_[i].bits.size(); ++b) {
        const Bit turned = m_.turned[i].code[b];
        if (turned == no) continue;
        const auto shown = rtl_.shown(registers_[i].bits[b]);
        if (!shown) {
          throw InputError(fmt::format("{}: register {} has no flip-flops of its own", m_.design,
                                       label_of(m_.turned[i].field)));
        }
        Bit& next = registers_now_[*shown].next;
        next = graph_.xor_of(next, turned);
      }
    }
  }
  bool has_mutants() const { return rtl_.width("mutsel") != 0; }

  // What the flip-flops hold when the first clock begins.
  Code after_reset() {
    const auto& flip_flops = rtl_.flip_flops();
    Code held;
    for (const auto& f : flip_flops) {
      held.push_back(f.initial == '0' ? no : f.initial == '1' ? yes : graph_.input());
    }
    for (int i = 0; i < m_.reset_clocks; ++i) {
      std::vector<Code> inputs;
      for (const nets::Wire& w : m_.inputs) {
        Code code;
        for (std::size_t b = 0; b < w.code.size(); ++b) code.push_back(graph_.input());
        for (const nets::Wire& given : m_.reset_inputs) {
          if (label_of(given.field) == label_of(w.field)) code = given.code;
        }
        inputs.push_back(std::move(code));
      }
      const Code nets = clock(held, inputs);
      for (std::size_t f = 0; f < held.size(); ++f) held[f] = placed_at(nets, flip_flops[f].next);
    }
    return held;
  }

  // The model's registers. It takes over from the RTL what no reset reaches, as in lockstep.
  void add_state(const Code& first) {
    std::size_t at = 0;
    for (const nets::Wire& w : m_.inputs) at += w.code.size();
    std::optional<Code> nets;  // of the RTL as it begins
    for (std::size_t i = 0; i < m_.state.size(); ++i) {
      Code begins = m_.begins[i].code;
      if (m_.state[i].field.unreset && is_taken_over()) {
        if (!nets) nets = clock(first, codes_of(m_.inputs));
        begins = taken_over(i, *nets);
      }
      for (std::size_t b = 0; b < begins.size(); ++b) {
        registers_now_.push_back({free_[at++], begins[b], m_.next[i].code[b]});
      }
    }
  }
  // Where its registers are its state.
  bool is_taken_over() const {
    return std::equal(m_.state.begin(), m_.state.end(), m_.registers.begin(), m_.registers.end(),
                      [](const nets::Wire& a, const nets::Wire& b) {
                        return label_of(a.field) == label_of(b.field);
                      });
  }
  static Code at(const RtlCell& cell, const Code& nets) {
    Code code;
    for (const Bit net : cell.bits) code.push_back(placed_at(nets, net));
    return code;
  }
  Code taken_over(std::size_t i, const Code& nets) {
    Code code = at(registers_[i], nets);
    if (m_.state[i].field.format != Format::ones_complement) return code;
    const nets::Number sign = nets::Number::unsigned_code(graph_, {code.back()});
    return (nets::Number::signed_code(graph_, code) + sign).code(static_cast<int>(code.size()));
  }

  Bit differs(const nets::Wire& w, const RtlCell& rtl, const Code& nets) {
    return where_compared(graph_, w, graph_.differ(w.code, at(rtl, nets)));
  }

  void ask_all(const Code& nets) {
    Asked& differ = asked_[Happens::differ];
    const auto& shown = m_.seen.empty() ? m_.registers : m_.seen;
    for (std::size_t i = 0; i < shown.size(); ++i) {
      differ.emplace_back("register " + label_of(shown[i].field),
                          differs(shown[i], registers_[i], nets));
    }
    for (std::size_t i = 0; i < m_.outputs.size(); ++i) {
      differ.emplace_back("output " + label_of(m_.outputs[i].field),
                          differs(m_.outputs[i], outputs_[i], nets));
    }
    // The first says that the fields have room; a code has it always.
    const auto& after = m_.invariant_after.front();
    differ.emplace_back("not so after it: " + after.name, !after.condition);
    for (std::size_t i = 1; i < m_.invariant.size(); ++i) {
      differ.emplace_back("not so: " + m_.invariant[i].name, !m_.invariant[i].condition);
    }
    for (const nets::Named& n : m_.idle) {
      asked_[Happens::stuck].emplace_back("idle inputs are not legal: " + n.name, !n.condition);
    }
    for (const auto& [name, net] : rtl_.unmet()) {
      asked_[Happens::assertion].emplace_back("not so: assertion " + name, stated(net, nets));
    }
    for (const nets::Named& n : m_.legal) legal_ = graph_.and_of(legal_, n.condition);
  }

  // On the first clock one that is sampled tells of the clock before, which is one of the reset.
  Bit stated(Bit net, const Code& nets) {
    const Bit is = placed_at(nets, net);
    return rtl_.is_sampled(net) ? graph_.and_of(is_later_, is) : is;
  }

  // Whether it happens on this clock. Of the clock before, which a net that toggles is compared
  // with, the first one knows nothing.
  Bit seen(const Watched& one, const Code& nets) {
    Bit any = no;
    for (const Bit net : one.toggles) {
      const Bit before = graph_.input(), now = placed_at(nets, net);
      registers_now_.push_back({before, no, now});
      any = graph_.or_of(any, graph_.and_of(is_later_, graph_.xor_of(before, now)));
    }
    for (const Bit net : one.holds) any = graph_.or_of(any, stated(net, nets));
    for (const auto* all : {&m_.cases, &m_.ways}) {
      for (const nets::Named& n : *all) {
        if (n.name == one.model_case) any = graph_.or_of(any, n.condition);
      }
    }
    return any;
  }

  void translate() {
    nets::Graph& graph = product_.graph;
    nets::Placing placing(graph_, graph);
    for (const nets::Wire& w : m_.inputs) {
      const std::optional<bool> resets = resets_at(w);
      for (const Bit bit : w.code) {
        if (bit.is_constant()) continue;
        if (w.field.synchronizer != nullptr && has_mutants()) {
          placing.give(bit, no);
        } else if (resets) {
          placing.give(bit, graph.seldom() ^ !*resets);
        } else {
          placing.give(bit, w.code.size() > 1 ? graph.input(label_of(w.field)) : graph.input());
        }
      }
    }
    Code firsts;
    for (const Register& r : registers_now_) firsts.push_back(r.first);
    placing.make(firsts);
    const Bit is_first = graph.latch(true);
    graph.next(is_first, no);
    placing.give(is_later_, !is_first);
    Code latches;
    for (const Register& r : registers_now_) {
      const Bit first = placing.of(r.first);
      latches.push_back(graph.latch(first == yes));
      placing.give(
          r.now, first.is_constant() ? latches.back() : graph.mux(is_first, first, latches.back()));
    }
    Code roots{legal_};
    for (const Register& r : registers_now_) roots.push_back(r.next);
    for (const auto& [what, bits] : asked_) {
      for (const auto& [name, bit] : bits) roots.push_back(bit);
    }
    placing.make(roots);
    for (std::size_t i = 0; i < latches.size(); ++i) {
      graph.next(latches[i], placing.of(registers_now_[i].next));
    }
    // All clocks so far, this one too; of a stuck one only those before.
    const Bit was_legal = legal_ == yes ? yes : graph.latch(true);
    const Bit is_legal = graph.and_of(was_legal, placing.of(legal_));
    if (legal_ != yes) graph.next(was_legal, is_legal);
    for (const auto& [what, bits] : asked_) {
      for (const auto& [name, bit] : bits) {
        const Bit allowed = what == Happens::stuck ? was_legal : is_legal;
        product_.asked[what].emplace_back(name, graph.and_of(allowed, placing.of(bit)));
      }
    }
    for (const nets::Wire& w : m_.inputs) {
      Code& own = product_.inputs.emplace_back();
      for (const Bit bit : w.code) own.push_back(placing.of(bit));
    }
  }

  // What an input of one bit is in a reset, if it is part of it.
  std::optional<bool> resets_at(const nets::Wire& w) const {
    for (const nets::Wire& given : m_.reset_inputs) {
      if (label_of(given.field) == label_of(w.field) && w.code.size() == 1 &&
          w.field.edge == cosim::Edge::none) {
        return given.code.front() == yes;
      }
    }
    return std::nullopt;
  }

  const nets::Machine& m_;
  const RtlNets& rtl_;
  const std::vector<Watched>& watched_;
  nets::Graph graph_;
  Bit is_later_ = graph_.input();  // than the first clock
  Code free_;                      // of the model
  Product product_;
  std::vector<RtlCell> inputs_, registers_, outputs_;
  std::map<std::size_t, Bit> tied_;  // by gate of the RTL
  std::vector<Register> registers_now_;
  std::map<Happens, Asked> asked_;
  Bit legal_ = yes;
};

}  // namespace

Product product_of(const nets::Model& model, const RtlNets& rtl,
                   const std::map<std::string, Word>& tied, const std::vector<Watched>& watched) {
  return ProductMaker(model, rtl, tied, watched).make();
}

}  // namespace cosim::proof
