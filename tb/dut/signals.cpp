// The hierarchy of a Verilated class, as the table of its public signals has it.
#include <verilated_syms.h>

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <string_view>

#include "tb/dut/adapter.h"

namespace cosim {
namespace {

// Verilator's registers lie in memory with the lowest byte first only where the machine does so.
static_assert(std::endian::native == std::endian::little);

// "TOP.uart.fifo.g__BRA__1__KET__" as {"uart", "fifo", "g[1]"}.
std::vector<std::string> scope_of(std::string path) {
  const auto replace = [&path](const std::string& from, const char* to) {
    for (std::size_t at; (at = path.find(from)) != std::string::npos;) {
      path.replace(at, from.size(), to);
    }
  };
  replace("__BRA__", "[");
  replace("__KET__", "]");
  std::vector<std::string> scope;
  std::size_t begin = path.find('.');
  while (begin != std::string::npos) {
    const std::size_t end = path.find('.', begin + 1);
    scope.push_back(path.substr(begin + 1, end == std::string::npos ? end : end - begin - 1));
    begin = end;
  }
  return scope;
}

}  // namespace

std::vector<Signal> signals_of(VerilatedContext& context) {
  std::vector<Signal> signals;
  for (const auto& [path, scope] : *context.scopeNameMap()) {
    const std::vector<std::string> names = scope_of(path);
    // The model's own scope has the pins a second time.
    if (scope->varsp() == nullptr || (names.size() == 1 && names.front() == "TOP")) continue;
    for (const auto& [name, var] : *scope->varsp()) {
      if (var.udims() != 0) continue;
      const int width = var.dims() == 0 ? 1 : var.packed().elements();
      signals.push_back({names, name, width, static_cast<const unsigned char*>(var.datap())});
    }
  }
  // A module's own signals stand before those of its instances.
  std::sort(signals.begin(), signals.end(), [](const Signal& a, const Signal& b) {
    return a.scope != b.scope ? a.scope < b.scope : a.name < b.name;
  });
  return signals;
}

void load_register(VerilatedContext& context, const std::string& net, Word value) {
  const std::size_t dot = net.rfind('.');
  const std::string name = dot == std::string::npos ? net : net.substr(dot + 1);
  const std::string below = dot == std::string::npos ? "" : '.' + net.substr(0, dot);
  bool found = false;
  for (const auto& [path, scope] : *context.scopeNameMap()) {
    if (scope->varsp() == nullptr || !std::string_view(path).ends_with(below)) continue;
    const auto var = scope->varsp()->find(name.c_str());
    if (var == scope->varsp()->end()) continue;
    auto* bytes = static_cast<unsigned char*>(var->second.datap());
    for (std::size_t i = 0; i < var->second.entSize(); ++i) {
      bytes[i] = static_cast<unsigned char>(i < sizeof value ? value >> (8 * i) : 0);
    }
    found = true;
  }
  if (!found) throw std::logic_error("no register " + net);
}

}  // namespace cosim
