#include "tb/rtl/resets.h"

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/rtl/regex.h"

namespace cosim::rtl {
namespace {

// A constant in hexadecimal without zeros before it; none where it is not known.
using Known = std::optional<std::string>;
// What processes assign to nets.
using Given = std::map<std::string, Known>;

bool is(const Known& known, std::string_view text) { return known && *known == text; }

class Constants {
 public:
  Constants(const Elaborated& design, const Levels& levels) : all_(design), levels_(levels) {}

  Given given_by(const std::vector<const Process*>& processes) {
    given_.clear();
    for (const Process* p : processes) follow(*p->body, *p->scope, false);
    return given_;
  }

 private:
  Known level_of(const Node& reference, const Scope& scope) const {
    const std::string net = all_.design.net_of(reference, scope);
    for (const auto& [reset, level] : levels_) {
      const Carried::Reach& reach = all_.reached.at(reset);
      if (reach.same.contains(net)) return level ? "1" : "0";
      if (reach.inverse.contains(net)) return level ? "0" : "1";
    }
    return {};
  }

  Known known(const Node& node, const Scope& scope) const {
    const std::string& tag = node.tag;
    const auto& in = node.in;
    if (tag == "const") {
      static const Regex digits("'s?h0*([0-9a-f]+)$");
      const Match found = digits.find(node.has("name"));
      return found ? Known(found[1]) : Known();
    }
    if (node.is_reference()) return level_of(node, scope);
    if (in.empty()) return {};
    if (tag == "cond") {
      const Known condition = known(*in[0], scope);
      return condition ? known(*in.at(*condition == "0" ? 2 : 1), scope) : Known();
    }
    std::vector<Known> of;
    for (const Node* one : in) of.push_back(known(*one, scope));
    const auto any = [&](const auto& holds) { return std::ranges::any_of(of, holds); };
    if (!any([](const Known& k) { return k.has_value(); })) return {};
    const auto is_tag = [&](std::initializer_list<std::string_view> tags) {
      return std::ranges::count(tags, std::string_view(tag)) != 0;
    };
    const bool is_bit = all_.design.size_of(node.has("dtype_id")) == 1;
    if (is_tag({"and", "logand"}) && any([](const Known& k) { return is(k, "0"); })) return "0";
    if (tag == "logor" && any([](const Known& k) { return k && *k != "0"; })) return "1";
    if (tag == "or" && is_bit && any([](const Known& k) { return is(k, "1"); })) return "1";
    if (any([](const Known& k) { return !k; })) return {};
    const std::string &first = *of[0], second = of.size() > 1 ? *of[1] : "";
    if (tag == "extend" || (tag == "extends" && first == "0")) return first;
    if (tag == "lognot" || (tag == "not" && is_bit)) return first == "0" ? "1" : "0";
    if (is_tag({"eq", "eqcase"})) return first == second ? "1" : "0";
    if (is_tag({"neq", "neqcase"})) return first == second ? "0" : "1";
    if (is_tag({"or", "logor"})) return "0";
    if (is_tag({"replicate", "shiftl", "sel"}) && first == "0") return "0";
    if (tag == "concat" && of.size() == 2 && first == "0" && second == "0") return "0";
    if (is_tag({"and", "logand"}) && first == "1" && second == "1") return "1";
    return {};
  }

  void follow_all(const Node& node, std::size_t from, const Scope& scope, bool is_unsure) {
    for (std::size_t i = from; i < node.in.size(); ++i) follow(*node.in[i], scope, is_unsure);
  }
  void follow(const Node& node, const Scope& scope, bool is_unsure) {
    const auto& in = node.in;
    if (node.is("sentree") || node.is("var")) return;
    if (node.tag.starts_with("assign") && in.size() > 1) {
      assign(known(*in[0], scope), *in[1], scope, is_unsure);
    } else if (node.is("if")) {
      const Known condition = known(*in[0], scope);
      if (!condition) return follow_all(node, 1, scope, true);
      if (*condition == "0") return follow_all(node, 2, scope, is_unsure);
      if (in.size() > 1) follow(*in[1], scope, is_unsure);
    } else if (node.is("case")) {
      follow_all(node, 1, scope, true);
    } else if (node.is("begin") && !node.has("name").empty()) {
      const std::string path = scope.path + node.has("name") + '.';
      follow_all(node, 0, all_.design.scope_in(node, path, &scope), is_unsure);
    } else if (!node.is("taskref") && !node.is("funcref")) {
      follow_all(node, 0, scope, is_unsure);
    }
  }
  void assign(const Known& value, const Node& target, const Scope& scope, bool is_unsure) {
    std::vector<const Node*> others;
    for (const NetPart& part : net_parts(all_.design, target, others)) {
      for (const std::string& net : all_.design.nets_of(*part.reference, scope)) {
        // All words of a memory, and all bits of a net, are 0 where each is.
        const auto before = given_.find(net);
        const bool is_zero = is(value, "0") && (before == given_.end() || is(before->second, "0"));
        given_[net] = !is_unsure && (target.is_reference() || is_zero) ? value : Known();
      }
    }
  }

  const Elaborated& all_;
  const Levels& levels_;
  Given given_;
};

// Of the inputs that are called so, the one and its level that give the most registers a constant.
Levels synchronous_reset(const Elaborated& design, const std::string& wanted,
                         const std::vector<const Process*>& processes) {
  static const Regex called_so("rst|reset|clr|clear", REG_ICASE);
  Levels best;
  std::ptrdiff_t most = 0;
  Given always = Constants(design, {}).given_by(processes);
  for (const std::string& name : design.inputs) {
    const bool is_asked = wanted.empty()
                              ? called_so.find(name) && design.design.net(name)->bits() == 1
                              : name == wanted;
    for (const bool level : {true, false}) {
      if (!is_asked) continue;
      const Levels levels{{name, level}};
      const Given given = Constants(design, levels).given_by(processes);
      const auto count = std::ranges::count_if(
          given, [&](const auto& one) { return one.second && !always[one.first]; });
      if (count <= most) continue;
      best = levels;
      most = count;
    }
  }
  return best;
}

void add_resets(Registers& found, const Levels& levels, Reset::Kind kind) {
  const auto begin = static_cast<std::ptrdiff_t>(found.resets.size());
  for (const auto& [name, level] : levels) found.resets.push_back({name, !level, kind});
  // Those that are low behind the others, as the tables have them.
  std::ranges::stable_sort(found.resets.begin() + begin, found.resets.end(), {},
                           [](const Reset& r) { return (r.is_active_low ? "low " : "") + r.name; });
}

}  // namespace

void find_resets(const Elaborated& design, const std::string& wanted, const Resets& resets,
                 Registers& found) {
  if (!wanted.empty() && !design.inputs.contains(wanted)) {
    throw InputError(wanted + ": the RTL has no such input, but it is named as its reset");
  }
  add_resets(found, resets.asynchronous, Reset::Kind::asynchronous);
  add_resets(found, resets.inner, Reset::Kind::inner);
  Levels active = resets.asynchronous;
  active.insert(resets.inner.begin(), resets.inner.end());
  const Levels at_once = active;
  // Each clock may have one of its own; a clock of registers that are reset at once needs none.
  std::map<std::string, std::vector<const Process*>> by_clock;
  std::vector<const Process*> clocked, initial;
  for (const Process& p : design.clocked) {
    by_clock[p.clock].push_back(&p);
    clocked.push_back(&p);
  }
  for (const Process& p : design.initial) initial.push_back(&p);
  for (const auto& [clock, processes] : by_clock) {
    const bool has_one = std::ranges::any_of(
        processes, [](const Process* p) { return !p->others.empty() && !p->is_inner; });
    if (has_one || (by_clock.size() == 1 && !resets.asynchronous.empty())) continue;
    for (const auto& [name, level] : synchronous_reset(design, wanted, processes)) {
      if (!active.try_emplace(name, level).second) continue;
      found.resets.push_back({name, !level, Reset::Kind::synchronous});
    }
  }
  if (active.size() > 1 || !resets.inner.empty()) {
    for (Reset& reset : found.resets) {
      if (!at_once.contains(reset.name)) continue;
      const Given given = Constants(design, {{reset.name, !reset.is_active_low}}).given_by(clocked);
      for (const Register& one : found.registers) {
        const auto value = given.find(one.name);
        if (value != given.end() && value->second) {
          reset.values.emplace_back(one.name, *value->second);
        }
      }
    }
  }
  const Given given = Constants(design, active).given_by(active.empty() ? initial : clocked);
  for (Register& one : found.registers) {
    if (const auto value = given.find(one.name); value != given.end()) one.value = value->second;
  }
}

}  // namespace cosim::rtl
