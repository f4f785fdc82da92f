// Finds the nets of a Verilated class by name, and compares its ports with a design's tables.
#include <fmt/core.h>
#include <verilated_syms.h>

#include <algorithm>
#include <map>

#include "model/core/input_error.h"
#include "tb/dut/named_adapter.h"

namespace cosim {
namespace {

const VerilatedScope* scope_of(VerilatedContext& context, const std::string& path) {
  const auto* all = context.scopeNameMap();
  const auto found = all->find(path.c_str());
  return found == all->end() ? nullptr : found->second;
}

int width_of(const VerilatedVar& var) { return var.dims() == 0 ? 1 : var.packed().elements(); }

Net net_of(const VerilatedVar& var) { return {var.datap(), static_cast<int>(var.entSize())}; }

[[noreturn]] void refuse(const std::string& title, const std::string& why) {
  throw InputError(title + ": " + why);
}

// The path of the top module. Beside it stands the class's own scope, which has the pins.
constexpr const char* pins = "TOP.TOP";
std::string top_of(VerilatedContext& context) {
  for (const auto& [path, scope] : *context.scopeNameMap()) {
    const std::string name = path;
    if (name != pins && name.starts_with("TOP.") && name.find('.', 4) == std::string::npos) {
      return name;
    }
  }
  return "TOP";
}

}  // namespace

std::vector<Net> find_ports(VerilatedContext& context, const Ports& ports) {
  const VerilatedScope* scope = scope_of(context, pins);
  if (scope == nullptr || scope->varsp() == nullptr) {
    refuse(ports.title, "its class does not show its ports");
  }
  std::map<std::string, const VerilatedVar*> left;
  for (const auto& [name, var] : *scope->varsp()) left[name] = &var;

  const auto take = [&](const char* what, const std::string& name, int width, int direction) {
    const auto found = left.find(name);
    if (found == left.end()) {
      refuse(ports.title, fmt::format("{} {}: the RTL has no such port", what, name));
    }
    const VerilatedVar& var = *found->second;
    if ((var.vldir() & VLVD_INOUT) != direction) {
      refuse(ports.title, fmt::format("{} {}: in the RTL it is no {}", what, name, what));
    }
    if (width_of(var) != width) {
      refuse(ports.title, fmt::format("{} {}: {} bits in the table, {} in the RTL", what, name,
                                      width, width_of(var)));
    }
    const Net net = net_of(var);
    left.erase(found);
    return net;
  };
  std::vector<Net> nets;
  for (const Field& f : ports.inputs) nets.push_back(take("input", f.net, f.width, VLVD_IN));
  for (const Field& f : ports.outputs) nets.push_back(take("output", f.net, f.width, VLVD_OUT));
  nets.push_back(take("clock", ports.clock, 1, VLVD_IN));
  if (!left.empty()) {
    const bool in = (left.begin()->second->vldir() & VLVD_INOUT) == VLVD_IN;
    refuse(ports.title, fmt::format("the RTL has an {} {} that no table names",
                                    in ? "input" : "output", left.begin()->first));
  }
  return nets;
}

Net find_register(VerilatedContext& context, const std::string& title, const Field& field) {
  const std::string net = field.net;
  const std::size_t dot = net.rfind('.');
  std::string path = top_of(context);
  if (dot != std::string::npos) path += '.' + net.substr(0, dot);
  const VerilatedScope* scope = scope_of(context, path);
  if (scope == nullptr || scope->varsp() == nullptr) {
    refuse(title, fmt::format("register {}: the RTL has no instance {}", net, net.substr(0, dot)));
  }
  const std::string name = dot == std::string::npos ? net : net.substr(dot + 1);
  const auto var = scope->varsp()->find(name.c_str());
  if (var == scope->varsp()->end() || var->second.udims() != 0) {
    refuse(title, fmt::format("register {}: the RTL has no such net", net));
  }
  if (width_of(var->second) != field.width) {
    refuse(title, fmt::format("register {}: {} bits in the table, {} in the RTL", net, field.width,
                              width_of(var->second)));
  }
  return net_of(var->second);
}

}  // namespace cosim
