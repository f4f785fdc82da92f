#include "tb/rtl/process.h"

#include <algorithm>

namespace cosim::rtl {
namespace {

using Sure = Process::Sure;

// What is sure behind some ways.
Sure meet(const std::vector<Sure>& ways) {
  Sure all{true};
  for (const Sure& way : ways) {
    if (way.is_left) continue;
    if (all.is_left) {
      all = way;
      continue;
    }
    for (auto& [net, bits] : all.bits) {
      const auto also = way.bits.find(net);
      bits &= also == way.bits.end() ? BitSet() : also->second;
    }
  }
  return all;
}

bool is_select(const Node& node) { return node.is("sel") || node.is("arraysel"); }

// Whether it is some bits of a net, and of nothing else.
bool is_part(const Node& node) {
  if (node.is_reference()) return true;
  return (is_select(node) || node.is("structsel")) && !node.in.empty() && is_part(*node.in[0]);
}

bool is_statement(const Node& node) {
  static const std::set<std::string> tags{"begin",   "if",      "case", "while",
                                          "taskref", "display", "stop", "finish"};
  return tags.contains(node.tag) || node.tag.starts_with("assign") ||
         (node.tag.starts_with("jump") && node.tag != "jump");
}

}  // namespace

std::vector<NetPart> net_parts(const Design& design, const Node& node,
                               std::vector<const Node*>& others) {
  const std::string& type = node.has("dtype_id");
  if (node.is_reference()) return {{&node, 0, design.size_of(type)}};
  std::vector<NetPart> all;
  if (node.tag.starts_with("concat")) {
    for (const Node* in : node.in) {
      const auto some = net_parts(design, *in, others);
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }
  if (node.in.empty()) return all;
  others.insert(others.end(), node.in.begin() + 1, node.in.end());
  all = net_parts(design, *node.in[0], others);
  for (NetPart& part : all) {
    const bool is_one = is_select(node) && all.size() == 1 && part.is_exact;
    const auto low = constant(node.in.size() > 1 ? node.in[1] : nullptr);
    const auto bits = node.is("sel") ? constant(node.in.size() > 2 ? node.in[2] : nullptr)
                                     : std::optional(design.size_of(type));
    part.is_exact = is_one && low && bits;
    if (!part.is_exact) continue;
    part.low += *low * (node.is("sel") ? 1 : *bits);
    part.bits = *bits;
  }
  return all;
}

void Reads::expose(const std::string& net) {
  const Net* is = design_.net(net);
  if (is != nullptr) exposed_[net] = BitSet(0, static_cast<std::size_t>(is->bits()));
}

void Reads::read(const std::string& net, const BitSet& bits, const Process& p) {
  if (!p.is_wire) values_.insert(net);
  if (p.sure.is_left) return;
  BitSet open = bits;
  if (const auto sure = p.sure.bits.find(net); sure != p.sure.bits.end()) open -= sure->second;
  exposed_[net] |= open;
}

void Reads::write(const NetPart& part, bool is_later, const Scope& scope, Process& p) {
  const auto nets = design_.nets_of(*part.reference, scope);
  const BitSet bits(static_cast<std::size_t>(std::max(part.low, 0L)),
                    static_cast<std::size_t>(std::max(part.bits, 0L)));
  for (const std::string& net : nets) {
    p.written[net] |= bits;
    if (is_later) {
      p.later[net] |= bits;
    } else if (nets.size() == 1 && (part.is_exact || p.loops > 0)) {
      p.sure.bits[net] |= bits;
    }
  }
}

void Reads::follow_all(const Node& node, const Scope& scope, Process& p) {
  for (const Node* in : node.in) follow(*in, scope, p);
}

void Reads::follow(const Node& node, const Scope& scope, Process& p) {
  const auto& in = node.in;
  std::vector<const Node*> others;
  if (node.is("sentree") || node.is("var")) return;
  if (node.tag.starts_with("assign") && in.size() > 1) {
    const auto to = net_parts(design_, *in[1], others);
    follow(*in[0], scope, p);
    for (std::size_t i = 2; i < in.size(); ++i) follow(*in[i], scope, p);
    for (const Node* other : others) follow(*other, scope, p);
    for (const NetPart& part : to) write(part, node.is("assigndly"), scope, p);
  } else if (node.is_reference() || is_select(node)) {
    if (!is_part(node)) return follow_all(node, scope, p);
    const auto from = net_parts(design_, node, others);
    for (const Node* other : others) follow(*other, scope, p);
    for (const NetPart& part : from) {
      const BitSet bits(static_cast<std::size_t>(std::max(part.low, 0L)),
                        static_cast<std::size_t>(std::max(part.bits, 0L)));
      for (const std::string& net : design_.nets_of(*part.reference, scope)) read(net, bits, p);
    }
  } else if (node.is("if") || node.is("case")) {
    choose(node, scope, p);
  } else if (node.is("while")) {
    ++p.loops;
    follow_all(node, scope, p);
    --p.loops;
  } else if (node.is("jumpblock")) {
    std::vector<Sure> outer;
    std::swap(outer, p.jumps);
    follow_all(node, scope, p);
    std::vector<Sure> ways{p.sure};
    ways.insert(ways.end(), p.jumps.begin(), p.jumps.end());
    outer.insert(outer.end(), p.jumps.begin(), p.jumps.end());  // which it leaves is not told
    p.sure = meet(ways);
    std::swap(outer, p.jumps);
  } else if (node.is("jumpgo")) {
    p.jumps.push_back(p.sure);
    p.sure = Sure{true};
  } else if (node.is("taskref") || node.is("funcref")) {
    call(node, scope, p);
  } else {
    const std::string& name = node.is("begin") ? node.has("name") : "";
    follow_all(node, name.empty() ? scope : design_.scope_in(node, scope.path + name + '.', &scope),
               p);
  }
}

// Of an `if` or a `case`.
void Reads::choose(const Node& node, const Scope& scope, Process& p) {
  follow(*node.in[0], scope, p);
  const Sure before = p.sure;
  std::vector<Sure> after;
  if (node.is("if") ? node.in.size() <= 2 : !has_all_items(node)) after.push_back(before);
  for (std::size_t i = 1; i < node.in.size(); ++i) {
    p.sure = before;
    follow(*node.in[i], scope, p);
    after.push_back(p.sure);
  }
  p.sure = meet(after);
}

// Whether the items of a case are all that there are.
bool Reads::has_all_items(const Node& node) const {
  const Node* value = node.in[0];
  while (value->is("extend")) value = value->in[0];
  std::set<long> values;
  for (std::size_t i = 1; i < node.in.size(); ++i) {
    const auto& in = node.in[i]->in;
    if (in.empty() || is_statement(*in[0])) return true;  // the default
    for (const Node* one : in) {
      if (const auto number = constant(one)) values.insert(*number);
    }
  }
  const long bits = design_.size_of(value->has("dtype_id"));
  return bits < 32 && static_cast<long>(values.size()) == 1L << bits;
}

// The arguments are read and given, what is in it follows, and what it gives is written.
void Reads::call(const Node& node, const Scope& scope, Process& p) {
  const std::string& name = node.has("name");
  const Task task = design_.task(name, scope);
  std::vector<const Node*> ports;
  const Scope* inner = nullptr;
  if (task.node != nullptr) {
    std::ranges::copy_if(task.node->in, std::back_inserter(ports), &Node::is_port);
    if (task.node->is("func") && !ports.empty()) ports.erase(ports.begin());
    inner = &design_.scope_in(*task.node, task.home->path + name + '.', task.home);
  }
  std::vector<const Node*> given;
  std::size_t next = 0;
  for (const Node* in : node.in) {
    if (!in->is("arg")) continue;
    for (const Node* argument : in->in) {
      const Node* const port = next < ports.size() ? ports[next++] : nullptr;
      const std::string way = port != nullptr ? port->has("dir") : "inout";
      if (way != "output") follow(*argument, scope, p);
      if (way != "input") given.push_back(argument);
      if (way != "input") continue;
      write({port, 0, design_.size_of(port->has("dtype_id"))}, false, *inner, p);
    }
  }
  if (task.node != nullptr && p.calls.insert(name).second) {
    follow_all(*task.node, *inner, p);
    p.calls.erase(name);
  }
  std::vector<const Node*> others;
  for (const Node* argument : given) {
    for (const NetPart& part : net_parts(design_, *argument, others)) {
      if (part.reference->is_reference()) write(part, false, scope, p);
    }
  }
}

}  // namespace cosim::rtl
