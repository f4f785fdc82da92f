// The hierarchy of a Verilated class, as the table of its public signals has it.
#include <verilated_syms.h>

#include <algorithm>
#include <bit>
#include <tuple>

#include "tb/dut/adapter.h"
#include "tb/dut/nets.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

// Verilator's registers lie in memory with the lowest byte first only where the machine does so.
static_assert(std::endian::native == std::endian::little);

// A wave shows no more words of a memory of the RTL.
constexpr int most_words = 256;

// "TOP.uart.fifo.g__BRA__1__KET__" as {"uart", "fifo", "g[1]"}.
std::vector<std::string> scope_of(const std::string& path) {
  std::vector<std::string> scope = parts_in(plain_path(path), '.');
  if (!scope.empty()) scope.erase(scope.begin());
  return scope;
}

}  // namespace

std::vector<Signal> signals_of(VerilatedContext& context, const std::string& clock) {
  std::vector<Signal> signals;
  for (const auto& [path, scope] : *context.scopeNameMap()) {
    const std::vector<std::string> names = scope_of(path);
    // The model's own scope has the pins a second time.
    if (scope->varsp() == nullptr || (names.size() == 1 && names.front() == "TOP")) continue;
    for (const auto& [name, var] : *scope->varsp()) {
      if (var.udims() > 1) continue;
      const int width = var.dims() == var.udims() ? 1 : var.packed().elements();
      const auto* bytes = static_cast<const unsigned char*>(var.datap());
      if (var.udims() == 0) {
        signals.push_back({names, name, width, bytes, -1, name == clock});
        continue;
      }
      const int words = std::min(var.unpacked().elements(), most_words);
      for (int i = 0; i < words; ++i, bytes += var.entSize()) {
        const int number = var.unpacked().low() + i;
        signals.push_back(
            {names, name + std::string("[") + std::to_string(number) + ']', width, bytes, number});
      }
    }
  }
  // A module's own signals stand before those of its instances.
  std::ranges::sort(signals, {}, [](const Signal& s) {
    return std::tuple(s.scope, s.name.substr(0, s.name.find('[')), s.word);
  });
  return signals;
}

}  // namespace cosim
