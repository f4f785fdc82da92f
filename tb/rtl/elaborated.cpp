#include "tb/rtl/elaborated.h"

#include <algorithm>

#include "model/core/input_error.h"

namespace cosim::rtl {
namespace {

constexpr std::string_view top_of_interface = "__Viftop";

std::string without_interface_top(std::string name) {
  if (name.ends_with(top_of_interface)) name.resize(name.size() - top_of_interface.size());
  return name;
}

// The name of a port, which may be given by its place.
std::string port_name(const Node& port, const Node& module) {
  static constexpr std::string_view numbered = "__pinNumber";
  const std::string& name = port.has("name");
  if (!name.starts_with(numbered)) return name;
  std::map<int, const Node*> by_place;
  for (const Node* in : module.in) {
    const std::string& place = in->is("var") ? in->has("pinIndex") : "";
    if (!place.empty() && place != "0") by_place[std::stoi(place)] = in;
  }
  // Of an interface the place is not told: it has the next that is free.
  int next = 1;
  for (const Node* in : module.in) {
    if (!in->is("var") || in->has("vartype") != "ifaceref") continue;
    if (in->has("name").ends_with(top_of_interface)) continue;
    while (by_place.contains(next)) ++next;
    by_place[next] = in;
  }
  const auto found = by_place.find(std::stoi(name.substr(numbered.size())));
  return found == by_place.end() ? "" : found->second->has("name");
}

// The parts of a nest of concatenations, the highest first.
void add_concatenated(const Node& value, std::vector<const Node*>& parts) {
  if (!value.is("concat")) return parts.push_back(&value);
  for (const Node* in : value.in) add_concatenated(*in, parts);
}

}  // namespace

Elaborated::Elaborated(const Tree& tree) : design(tree) {
  for (const Node* package : design.packages()) {
    const std::string path = package->has("name") + '.';
    design.declare(*package, path);
    design.publish(design.scope_in(*package, path, nullptr));
  }
  design.declare(design.top(), "");
  walk(design.top(), "", nullptr);
  for (const Node* in : design.top().in) {
    if (!in->is_port()) continue;
    const std::string &name = in->has("name"), &way = in->has("dir");
    if (way == "inout") throw InputError(name + ": a port of both directions");
    if (way == "input") inputs.insert(name);
    if (way == "output") {
      outputs.insert(name);
      outputs_in_order.push_back(name);
    }
    reads.expose(name);
  }
  for (const std::string& input : inputs) reached[input] = carried.reach(input);
}

std::string Elaborated::input_of(const std::string& net, bool is_inverse) const {
  for (const std::string& input : inputs) {
    const Carried::Reach& reach = reached.at(input);
    if ((is_inverse ? reach.inverse : reach.same).contains(net)) return input;
  }
  return "";
}

bool Elaborated::is_carried_to_output(const std::string& net) const {
  const auto carriers = carried.carriers(net);
  return std::ranges::any_of(carriers, [&](const auto& carrier) {
    return carrier.first != net && reads.exposed().contains(carrier.first);
  });
}

// What is in one instance of a module.
void Elaborated::walk(const Node& node, const std::string& path, const Scope* around) {
  const Scope& scope = design.scope_in(node, path, around);
  for (const Node* in : node.in) {
    const std::string& name = in->has("name");
    if (in->is("begin")) {
      walk(*in, name.empty() ? path : path + name + '.', &scope);
    } else if (in->is("instance")) {
      const Node* const module = design.module(in->has("defName"));
      if (module == nullptr) continue;
      const std::string below = path + name + '.';
      for (const Node* port : in->in) {
        if (!port->in.empty()) connect(*port, below + port_name(*port, *module), scope);
      }
      walk(*module, below, nullptr);
    } else if (in->is("contassign")) {
      assign(*in, scope);
    } else if (in->tag.starts_with("always") || in->tag.starts_with("initial")) {
      add_process(*in, scope);
    }
  }
}

void Elaborated::assign(const Node& node, const Scope& scope) {
  const Node &value = *node.in.at(0), &target = *node.in.at(1);
  Process wire{.body = &node, .scope = &scope, .is_wire = value.is_reference()};
  reads.follow(value, scope, wire);
  const std::string to = target.is_reference() ? design.net_of(target, scope) : "";
  if (to.empty()) return;
  invert(value, to, scope);
  std::vector<const Node*> parts;
  add_concatenated(value, parts);
  long low = 0;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    const std::string from = (*part)->is_reference() ? design.net_of(**part, scope) : "";
    if (!from.empty()) carried.carry(from, to, low);
    low += design.size_of((*part)->has("dtype_id"));
  }
}

void Elaborated::invert(const Node& value, const std::string& to, const Scope& scope) {
  if (!value.is("not") || value.in.empty() || !value.in[0]->is_reference()) return;
  const std::string from = design.net_of(*value.in[0], scope);
  if (!from.empty()) carried.invert(from, to);
}

void Elaborated::add_process(const Node& node, const Scope& scope) {
  Process p{.body = &node, .scope = &scope};
  std::vector<const Node*> others;
  bool has_edges = false;
  for (const Node* item : all_of(node, "senitem")) {
    const std::string& way = item->has("edgeType");
    if (!way.starts_with("POS") && !way.starts_with("NEG") && !way.starts_with("BOTH")) continue;
    has_edges = true;
    for (const Node* in : item->in) {
      for (const NetPart& part : net_parts(design, *in, others)) {
        const std::string net = design.net_of(*part.reference, scope);
        p.edges.push_back({way, net.empty() ? part.reference->has("name") : net});
      }
    }
  }
  if (!has_edges && node.tag.starts_with("initial")) {
    initial.push_back(std::move(p));
    return;
  }
  for (const Node* in : node.in) reads.follow(*in, scope, p);
  if (!has_edges) return;
  for (const Node* in : node.in) {
    if (in->is("sentree")) continue;
    std::vector<const Node*> references = all_of(*in, "varref");
    for (const Node* one : all_of(*in, "varxref")) references.push_back(one);
    if (in->is_reference()) references.push_back(in);
    for (const Node* one : references) {
      for (const std::string& net : design.nets_of(*one, scope)) p.tested.insert(net);
    }
  }
  clocked.push_back(std::move(p));
}

// A port of an instance, `inner` by its path.
void Elaborated::connect(const Node& port, const std::string& inner, const Scope& scope) {
  const Node& value = *port.in[0];
  const std::string& way = port.has("direction");
  if (way.empty()) {  // an interface
    design.alias(inner, scope.path + without_interface_top(value.has("name")));
    return;
  }
  const std::string net = value.is_reference() ? design.net_of(value, scope) : "";
  if (way == "out") {
    reads.expose(inner);
    if (!net.empty()) carried.carry(inner, net, 0);
    return;
  }
  Process wire{.body = &port, .scope = &scope, .is_wire = value.is_reference()};
  reads.follow(value, scope, wire);
  if (!net.empty()) carried.carry(net, inner, 0);
  invert(value, inner, scope);
}

}  // namespace cosim::rtl
