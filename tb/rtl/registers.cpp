#include "tb/rtl/registers.h"

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/rtl/clocks.h"
#include "tb/rtl/files.h"
#include "tb/rtl/held.h"
#include "tb/rtl/regex.h"
#include "tb/rtl/resets.h"

namespace cosim::rtl {
namespace {

class RegisterReader {
 public:
  explicit RegisterReader(const RegistersAsked& asked)
      : tree_(asked.tree), all_(tree_), warnings_(asked.warnings) {
    const std::size_t colon = std::min(asked.clocks.find(':'), asked.clocks.size());
    if (colon < asked.clocks.size()) wanted_reset_ = asked.clocks.substr(colon + 1);
    give_clocks_of(asked.clocks.substr(0, colon));
    find_registers();
    find_inner_resets();
    find_latches();
    if (!asked.netlist.empty()) add_held(read_held(asked.netlist));
    if (latches_.empty()) return;
    const auto& [net, place] = *latches_.begin();
    throw InputError(net + ": a latch" + (place.empty() ? "" : " in " + place));
  }

  Registers take() {
    Registers found;
    for (const auto& [name, bits] : registers_) {
      const Net& net = *all_.design.net(name);
      Register one{name, net.width, net.words, bits.ranges()};
      for (const auto& [carrier, low] : all_.carried.carriers(name)) {
        const Net* is = carrier == name ? nullptr : all_.design.net(carrier);
        if (is != nullptr) one.carriers.push_back({carrier, is->width, is->words, low});
      }
      for (const Process& p : all_.clocked) {
        if (clocks_.size() > 1 && p.held.contains(name)) one.clocks.push_back(p.clock);
      }
      found.registers.push_back(std::move(one));
    }
    found.outputs.assign(all_.outputs_in_order.begin(), all_.outputs_in_order.end());
    for (const std::string& clock : clocks_) {
      const auto way = ways_.find(clock);
      found.clocks.push_back({clock, way != ways_.end() && way->second != "POS"});
    }
    find_resets(all_, wanted_reset_, resets_, found);
    static const Regex loop("^%Warning-UNOPTFLAT: [^'\n]*'([^']+)'", REG_NEWLINE);
    for (const Match& m : loop.all(warnings_)) found.loops.push_back(below_top(m[1]));
    return found;
  }

 private:
  // `text` as of RegistersAsked, without the reset.
  void give_clocks_of(const std::string& text) {
    const bool is_asked = text == "?", is_one = text.find(',') == text.npos;
    for (std::size_t at = 0; !is_asked && text != "-" && at < text.size();) {
      const std::size_t end = std::min(text.find(',', at), text.size());
      if (end > at) clocks_.push_back(text.substr(at, end - at));
      at = end + 1;
    }
    for (const std::string& clock : clocks_) {
      if (all_.inputs.contains(clock)) continue;
      throw InputError(clock + ": the RTL has no such input, but it is named as its clock");
    }
    for (Process& p : all_.clocked) p.held = held_by(p);
    std::erase_if(all_.clocked, [](const Process& p) { return p.held.empty(); });
    for (const Process& p : all_.clocked) require_one_edge(all_, p);
    if (is_asked) clocks_ = found_clocks(all_);
    if (!all_.clocked.empty() && clocks_.empty()) {
      throw InputError(all_.clocked.front().first_held() +
                       ": a register, but the design is declared COMBINATIONAL");
    }
    ways_ = give_clocks(all_, clocks_, !is_asked && is_one);
    if (clocks_.size() < 2 && is_one) return;
    for (const std::string& clock : clocks_) require_plain(all_, clock);
  }
  Bits held_by(const Process& p) const {
    Bits held;
    for (const auto& [net, bits] : p.written) {
      if (all_.design.net(net) == nullptr) continue;
      BitSet state = bits;
      const auto read = all_.reads.exposed().find(net);
      if (!all_.is_carried_to_output(net)) {
        state &= read == all_.reads.exposed().end() ? BitSet() : read->second;
      }
      if (const auto later = p.later.find(net); later != p.later.end()) state |= later->second;
      if (!state.is_empty()) held[net] = state;
    }
    return held;
  }

  void find_registers() {
    // Verilator keeps what an assertion samples in such a variable.
    static const Regex sampled("(^|[.])_Vpast_[0-9]+_[0-9]+$");
    for (Process& p : all_.clocked) {
      const std::string& named = p.first_held();
      if (p.others.size() > 1) {
        throw InputError(named + ": an asynchronous set and reset, " + p.others[0].net + " and " +
                         p.others[1].net);
      }
      if (!p.others.empty()) {
        const auto& [way, net] = p.others[0];
        const std::string input = all_.input_of(net, false), inverse = all_.input_of(net, true);
        const bool is_low = (way == "NEG") != input.empty();
        p.is_inner = input.empty() && inverse.empty();
        if (!p.is_inner) resets_.asynchronous.emplace(input.empty() ? inverse : input, !is_low);
      }
      for (const auto& [net, bits] : p.held) {
        if (!sampled.find(net)) registers_[net] |= bits;
      }
    }
  }
  // A register of one bit may reset others, itself or inverted.
  void find_inner_resets() {
    for (const Process& p : all_.clocked) {
      if (!p.is_inner) continue;
      const auto& [way, net] = p.others[0];
      std::string by;
      bool is_inverse = false;
      for (const auto& [candidate, bits] : registers_) {
        if (all_.design.net(candidate)->bits() != 1) continue;
        const Carried::Reach reach = all_.carried.reach(candidate);
        if (!reach.same.contains(net) && !reach.inverse.contains(net)) continue;
        by = candidate;
        is_inverse = reach.inverse.contains(net);
      }
      if (by.empty()) {
        throw InputError(p.first_held() + ": an asynchronous reset by " + net +
                         ", which is no input");
      }
      all_.reached[by] = all_.carried.reach(by);
      resets_.inner.emplace(by, (way == "NEG") == is_inverse);
    }
  }

  // The variable of a loop, which is always written before it is read, holds nothing.
  void find_latches() {
    static const Regex latch(
        "^%Warning-LATCH: (.*/)?([^/]+:[0-9]+):[0-9]+: Latch inferred for signal '([^']+)'",
        REG_NEWLINE);
    for (const Match& m : latch.all(warnings_)) {
      const std::string net = below_top(m[3]);
      const auto read = all_.reads.exposed().find(net);
      const bool is_read = read != all_.reads.exposed().end() && !read->second.is_empty();
      if (all_.design.net(net) == nullptr || is_read || all_.is_carried_to_output(net)) {
        latches_.try_emplace(net, m[2]);
      }
    }
  }

  // The net of the tree and its bit that a name of yosys is; "" where there is none.
  std::pair<std::string, long> place_of(const NamedBit& name) const {
    const Net* net = all_.design.net(name.net);
    if (net != nullptr && net->bits() == name.width) return {name.net, name.bit};
    static const Regex word("^(.*)\\[([0-9]+)\\]$");
    const Match m = word.find(name.net);
    net = m ? all_.design.net(m[1]) : nullptr;
    if (net == nullptr || net->words <= 0 || net->width != name.width) return {};
    return {m[1], (std::stol(m[2]) - net->first) * net->width + name.bit};
  }
  void hold(const std::string& net, long low, long count) {
    registers_[net] |= BitSet(static_cast<std::size_t>(low), static_cast<std::size_t>(count));
  }
  // What yosys found besides.
  void add_held(const Held& held) {
    for (const std::string& memory : held.memories) {
      const Net* net = all_.design.net(memory);
      if (net != nullptr && !registers_.contains(memory)) hold(memory, 0, net->bits());
    }
    const auto places_of = [&](const std::vector<NamedBit>& names) {
      std::vector<std::pair<std::string, long>> places;
      for (const NamedBit& name : names) {
        if (const auto place = place_of(name); !place.first.empty()) places.push_back(place);
      }
      return places;
    };
    for (const auto& names : held.latches) {
      const auto places = places_of(names);
      latches_.try_emplace(places.empty() ? names[0].net : places[0].first);
    }
    for (const auto& names : held.registers) {
      auto places = places_of(names);
      const bool is_known = std::ranges::any_of(places, [&](const auto& place) {
        const auto known = registers_.find(place.first);
        return known != registers_.end() &&
               known->second.has(static_cast<std::size_t>(place.second));
      });
      if (is_known) continue;
      if (places.empty()) {
        all_.design.add(names[0].net, {.width = names[0].width});
        places = {{names[0].net, names[0].bit}};
      }
      hold(places[0].first, places[0].second, 1);
    }
  }

  std::string below_top(std::string name) const {
    const std::string begin = all_.design.top().has("name") + '.';
    if (name.starts_with(begin)) name.erase(0, begin.size());
    static const Regex point("__DOT__");
    return point.replaced(name, ".");
  }

  Tree tree_;
  Elaborated all_;
  std::string warnings_, wanted_reset_;
  std::vector<std::string> clocks_;
  std::map<std::string, std::string> latches_;  // nets, and where they are if that is known
  std::map<std::string, std::string> ways_;
  Bits registers_;
  Resets resets_;
};

}  // namespace

Registers registers_in(const RegistersAsked& asked) { return RegisterReader(asked).take(); }

}  // namespace cosim::rtl
