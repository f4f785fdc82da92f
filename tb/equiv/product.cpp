#include "tb/equiv/product.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "tb/equiv/clocks.h"

namespace cosim::equiv {
namespace {

// One copy of a side in the graph.
struct Copy {
  Bits state, own;  ///< what its gates see of a register, and the latch that holds it
};

class Builder {
 public:
  Builder(const Question& q, Registers registers, const Unknown& unknown, const Pairs& memories)
      : q_(q),
        one_(registers == Registers::one),
        any_(!unknown.fillers.empty()),
        free_(unknown.free),
        fillers_(unknown.fillers),
        memories_(memories) {}

  Product made() {
    first_ = one_ ? no : graph_.latch(true);
    if (!one_) graph_.next(first_, no);
    Bit resets = no;
    if (!one_) {
      for (int i = 0; i < q_.reset_clocks; ++i) {
        const Bit before = resets;
        resets = graph_.latch(true);
        graph_.next(resets, before);
      }
    }
    // In one clock from any state it may be one of the reset, in which nothing is assumed.
    if (one_ && !q_.assumed.empty() && q_.reset_clocks > 0) resets = graph_.seldom();
    resets_ = resets;
    // The names of the old RTL's registers, and what each begins as.
    for (std::size_t i = 0; i < q_.gold.registers.size(); ++i) {
      if (!q_.gold.registers[i].name.first.empty()) gold_at_[q_.gold.registers[i].name] = i;
    }
    for (const Register& r : q_.gate.registers) {
      if (!r.name.first.empty()) gate_names_[r.name] = &r;
    }
    Bits gate_unknown(q_.gate.unknowns);
    for (Bit& lit : gate_unknown) lit = named(graph_.input(), "x of the new RTL");
    const bool as_many = q_.gold.unknowns == q_.gate.unknowns;

    const std::size_t copies = any_ ? fillers_.size() : 1;
    std::vector<Copy> golds;
    std::vector<Side::Made> made_golds;
    for (std::size_t c = 0; c < copies; ++c) {
      Bits unknown(q_.gold.unknowns);
      for (std::size_t i = 0; i < unknown.size(); ++i) {
        unknown[i] = any_ ? filler(c, i) : free_ ? free() : as_many ? gate_unknown[i] : no;
      }
      golds.push_back(gold_copy(c));
      made_golds.push_back(make(q_.gold, golds.back(), unknown, false));
    }
    const Copy gate = gate_copy(golds.front());
    const Side::Made made_gate = make(q_.gate, gate, gate_unknown, true);

    Bit bad = no;
    for (const auto& [name, gold] : made_golds.front().outputs) {
      if (q_.gold.outputs.contains(name.first)) {
        bad = graph_.or_of(bad, differ(name, made_golds, made_gate));
      }
    }
    Bit strays = no;
    for (const auto& [i, j] : memories_) {
      for (const Side::Made& gold : made_golds) {
        strays = graph_.or_of(strays, strays_of(graph_, {q_.gold.memories[i], i, gold},
                                                {q_.gate.memories[j], j, made_gate}));
      }
    }
    // What is in a memory has to be the same before there is an output too, and what is in a
    // register.
    if (one_) {
      for (const auto& [i, j] : pairs_) {
        strays = graph_.or_of(strays, graph_.xor_of(made_golds[0].next[i], made_gate.next[j]));
      }
    }
    product_.differ = graph_.and_of(bad, !settling());
    product_.bad = graph_.or_of(strays, product_.differ);
    assume(made_golds.front());
    product_.matched = pairs_.size();
    product_.beginnings = shared_;
    product_.graph = graph_;
    return product_;
  }

 private:
  // The value that a copy gives the i-th bit of an x: of a clock or, `at_first`, of the first.
  Bit filler(std::size_t copy, std::size_t i, bool at_first = false) {
    const Filler& rows = fillers_[copy];
    if (at_first || rows.size() == 1) return rows.front()[i] ? yes : no;
    Bit value = no, before = no;
    for (std::size_t t = 0; t + 1 < rows.size(); ++t) {
      if (rows[t][i]) value = graph_.or_of(value, clock(t));
      before = graph_.or_of(before, clock(t));
    }
    return rows.back()[i] ? graph_.or_of(value, !before) : value;
  }

  // Whether it is clock t.
  Bit clock(std::size_t t) {
    if (clocks_.empty()) clocks_.push_back(first_);
    while (clocks_.size() <= t) clocks_.push_back(delayed(clocks_.back()));
    return clocks_[t];
  }

  Bit named(Bit bit, const std::string& name) {
    product_.names[bit.gate()] = name;
    return bit;
  }
  Bit named(Bit bit, const Name& name, const char* of) {
    return name.first.empty() ? bit
                              : named(bit, fmt::format("{}[{}]{}", name.first, name.second, of));
  }

  Bit free() {
    const Bit input = named(graph_.input(), "any");
    product_.free.insert(input);
    return input;
  }

  bool any_in_both(const Register& gold) const {
    const auto partner = gate_names_.find(gold.name);
    return partner != gate_names_.end() && partner->second->any;
  }

  Bit starting(Bit first, Bit latch) { return graph_.mux(first_, first, latch); }

  Copy gold_copy(std::size_t c) {
    Copy copy;
    std::size_t alone = q_.gold.unknowns;
    for (const Register& r : q_.gold.registers) {
      const Bit latch =
          named(one_ ? graph_.input() : graph_.latch(r.first), r.name, " of the old RTL");
      copy.own.push_back(latch);
      const auto begins = [&](Bit lit) {
        if (c == 0) product_.gold_begins.push_back(lit);
      };
      if (!r.any || one_) {
        begins(r.first ? yes : no);
        copy.state.push_back(latch);
        product_.alone_any = product_.alone_any || (r.any && !any_in_both(r));
        continue;
      }
      if (any_in_both(r)) {
        const auto [at, is_new] = shared_.try_emplace(r.name, no);
        if (is_new) at->second = named(graph_.input(), r.name, " at first");
        begins(at->second);
        copy.state.push_back(starting(at->second, latch));
      } else {
        begins(unknown_begin);
        product_.alone_any = true;
        copy.state.push_back(starting(any_ ? filler(c, alone++, true) : free(), latch));
      }
    }
    return copy;
  }

  Copy gate_copy(const Copy& gold) {
    Copy copy;
    for (std::size_t j = 0; j < q_.gate.registers.size(); ++j) {
      const Register& r = q_.gate.registers[j];
      const auto partner = gold_at_.find(r.name);
      if (partner != gold_at_.end()) {
        const Register& other = q_.gold.registers[partner->second];
        if (other.any == r.any && (r.any || other.first == r.first)) {
          pairs_.emplace_back(partner->second, j);
          if (one_) {
            copy.own.push_back(named(gold.own[partner->second], r.name, ""));
            copy.state.push_back(gold.state[partner->second]);
            continue;
          }
        }
      }
      const Bit latch =
          named(one_ ? graph_.input() : graph_.latch(r.first), r.name, " of the new RTL");
      copy.own.push_back(latch);
      if (!r.any || one_) {
        product_.gate_begins.push_back(r.first ? yes : no);
        copy.state.push_back(latch);
        continue;
      }
      const auto shared = shared_.find(r.name);
      product_.gate_begins.push_back(shared == shared_.end() ? graph_.input() : shared->second);
      copy.state.push_back(starting(product_.gate_begins.back(), latch));
    }
    return copy;
  }

  // A bit of an input as a side gets it.
  Bit input(const Name& name, const Side& side, bool is_gate) {
    std::string port = name.first;
    if (const auto pins = read_pins(is_gate); pins.contains(port)) {
      const auto [at, is_new] = reads_.try_emplace({pins.at(port), name.second}, no);
      if (is_new) at->second = free();
      return at->second;
    }
    const auto clock = side.clocks.find(port);
    const bool is_clock = clock != side.clocks.end();
    if (is_clock && !q_.steps && clock_rests_) return clock->second ? yes : no;
    if (is_gate) port = gold_name(q_, port);
    // The one clock may have another name in the other.
    if (is_clock && !q_.steps && !q_.gold.clocks.empty()) port = q_.gold.clocks.begin()->first;
    if (const auto tied = tied_bit(q_, {port, name.second})) return *tied ? yes : no;
    const auto [at, is_new] = product_.inputs.try_emplace({port, name.second}, no);
    if (is_new) {
      const auto reset = q_.resets->find(port);
      const bool is_reset = reset != q_.resets->end();
      at->second = is_reset ? named(graph_.seldom(), "resets by " + port)
                            : named(graph_.input(port), at->first, "");
      product_.widths[port] = side.inputs.at(name.first);
      if (is_clock && q_.steps) at->second = graph_.or_of(at->second, resets_);
      if (is_reset) {
        const Bit resets = graph_.or_of(at->second, resets_);
        at->second = reset->second ? resets : !resets;
      }
    }
    return at->second;
  }

  Side::Made make(const Side& side, const Copy& copy, const Bits& unknown, bool is_gate) {
    const auto its_input = [&](const Name& name) { return input(name, side, is_gate); };
    Side::Made made = side.make(graph_, its_input, unknown, copy.state);
    // Registers take over what is there before the edge; outputs are seen on either side of it.
    if (!side.clocks_as_data.empty()) {
      clock_rests_ = false;
      for (const auto& [name, lit] : side.make(graph_, its_input, unknown, copy.state).outputs) {
        if (side.outputs.contains(name.first)) made.outputs[name] = lit;
      }
      clock_rests_ = true;
    }
    if (!one_) {
      for (std::size_t i = 0; i < made.next.size(); ++i) graph_.next(copy.own[i], made.next[i]);
    }
    return made;
  }

  // Nothing is bad from the first clock on that does not keep to what is assumed.
  void assume(const Side::Made& gold) {
    if (q_.assumed.empty()) return;
    Bit holds = resets_;
    Bit all = yes;
    for (const Assumption& one : q_.assumed) {
      const auto port = [&](const Name& name) {
        const auto output = gold.outputs.find(name);
        return output == gold.outputs.end() ? input(name, q_.gold, false) : output->second;
      };
      const Side::Made made = one.logic.make(graph_, port, {}, {});
      all = graph_.and_of(all, made.outputs.at({"cosim_holds", 0}));
    }
    holds = graph_.or_of(holds, all);
    if (!one_) {
      const Bit before = graph_.latch(true);
      holds = graph_.and_of(before, holds);
      graph_.next(before, holds);
    }
    for (Bit* bad : {&product_.bad, &product_.differ}) *bad = graph_.and_of(*bad, holds);
    product_.held = graph_.and_of(holds, !resets_);
  }

  // The pins of a side that have what memories read, and those of the old RTL that are the same.
  std::map<std::string, std::string> read_pins(bool is_gate) const {
    std::map<std::string, std::string> pins;
    for (const auto& [i, j] : memories_) {
      pins[memory_port(is_gate ? j : i, "RD_DATA")] = memory_port(i, "RD_DATA");
    }
    return pins;
  }

  // While it resets, and until the first outputs of the new RTL can have come.
  Bit settling() {
    Bit all = resets_;
    Bit last = resets_;
    for (int i = 0; i < q_.latency; ++i) {
      last = delayed(last, true);
      all = graph_.or_of(all, last);
    }
    return all;
  }

  Bit delayed(Bit lit, bool first = false) {
    const Bit latch = graph_.latch(first);
    graph_.next(latch, lit);
    return latch;
  }

  // An output of both, where both have it and it is to be compared.
  Bit differ(const Name& name, const std::vector<Side::Made>& golds, const Side::Made& gate) {
    if (std::ranges::find(q_.ignored, name.first) != q_.ignored.end()) return no;
    const auto other = gate.outputs.find({gate_name(q_, name.first), name.second});
    if (other == gate.outputs.end()) throw std::logic_error("no output " + name.first);
    Bit gold = golds.front().outputs.at(name);
    Bit unknown = no;
    for (const Side::Made& copy : golds) {
      unknown = graph_.or_of(unknown, graph_.xor_of(gold, copy.outputs.at(name)));
    }
    for (int i = 0; i < q_.latency; ++i) {
      gold = delayed(gold);
      unknown = delayed(unknown);
    }
    product_.gold[name] = gold;
    product_.gate[name] = other->second;
    product_.any[name] = unknown;
    return graph_.and_of(graph_.xor_of(gold, other->second), !unknown);
  }

  const Question& q_;
  bool one_, any_, free_;
  bool clock_rests_ = true;  ///< a clock that is read is as it is before its edge
  const std::vector<Filler>& fillers_;
  const Pairs& memories_;
  Graph graph_;
  Bit first_ = no, resets_ = no;
  std::map<Name, std::size_t> gold_at_;
  std::map<Name, const Register*> gate_names_;
  Bits clocks_;
  std::map<Name, Bit> reads_;   ///< what memories read, by the old RTL's pins
  std::map<Name, Bit> shared_;  ///< what registers of that name begin as in both
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
  Product product_;
};

}  // namespace

Product product_of(const Question& question, Registers registers, const Unknown& unknown,
                   const Pairs& memories) {
  return Builder(question, registers, unknown, memories).made();
}

std::size_t unknown_bits(const Question& question) {
  return question.gold.unknowns + question.gold.registers.size();
}

}  // namespace cosim::equiv
