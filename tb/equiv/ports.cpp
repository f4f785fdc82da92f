#include "tb/equiv/ports.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "model/core/input_error.h"
#include "tb/equiv/clocks.h"
#include "tb/support/words.h"

namespace cosim::equiv {
namespace {

using Widths = std::map<std::string, int>;

// Ports of one side that the other lacks, or has in another width.
void find_lacking(const Question& q, const Widths& gold, const Widths& gate, bool inputs,
                  std::vector<std::string>& lacking) {
  const auto is_free = [&](const std::string& port) {
    if (inputs && !q.steps && (q.gold.clocks.contains(port) || q.gate.clocks.contains(port))) {
      return true;
    }
    return inputs ? q.tied.contains(port) : std::ranges::find(q.ignored, port) != q.ignored.end();
  };
  std::set<std::string> met;
  for (const auto& [port, width] : gold) {
    const std::string other = gate_name(q, port);
    met.insert(other);
    if (is_free(port)) continue;
    const auto at = gate.find(other);
    if (at == gate.end()) {
      lacking.push_back(port + " only in the old");
    } else if (at->second != width) {
      lacking.push_back(fmt::format("{} has {} bits and {}", port, width, at->second));
    }
  }
  for (const auto& [port, width] : gate) {
    if (!met.contains(port) && !is_free(port)) lacking.push_back(port + " only in the new");
  }
}

// What the options name.
void require_named(const Question& q) {
  for (const auto& [pin, value] : q.tied) {
    const std::string other = gate_name(q, pin);
    const bool is_old = q.gold.inputs.contains(pin);
    if (!is_old && !q.gate.inputs.contains(other)) {
      throw InputError(fmt::format("--tie: {} is no input", in_quotes(pin)));
    }
    const int width = is_old ? q.gold.inputs.at(pin) : q.gate.inputs.at(other);
    if (value.size() > static_cast<std::size_t>(width)) {
      throw InputError(fmt::format("--tie: {} has {}, and the value {}", in_quotes(pin),
                                   count(static_cast<std::uint64_t>(width), "bit"), value.size()));
    }
    const bool is_clock = q.gold.clocks.contains(pin) || q.gate.clocks.contains(other);
    if (is_clock && (!q.steps || value != "0")) {
      throw InputError(fmt::format("--tie: {} is a clock", in_quotes(pin)));
    }
  }
  for (const std::string& pin : q.ignored) {
    if (!q.gold.outputs.contains(pin) && !q.gate.outputs.contains(pin)) {
      throw InputError(fmt::format("--ignore: {} is no output", in_quotes(pin)));
    }
  }
  for (const auto& [pin, other] : q.renamed) {
    if (!q.gold.declared.contains(pin)) {
      throw InputError(fmt::format("--map: the old RTL has no port {}", in_quotes(pin)));
    }
    if (!q.gate.declared.contains(other)) {
      throw InputError(fmt::format("--map: the new RTL has no port {}", in_quotes(other)));
    }
  }
}

}  // namespace

void require_ports(const Question& q) {
  require_named(q);
  std::vector<std::string> lacking;
  find_lacking(q, q.gold.inputs, q.gate.inputs, true, lacking);
  find_lacking(q, q.gold.outputs, q.gate.outputs, false, lacking);
  if (!lacking.empty()) {
    throw InputError(fmt::format(
        "the ports differ: {}; write --tie INPUT=VALUE, --ignore OUTPUT or --map OLD=NEW",
        fmt::join(lacking, ", ")));
  }
  for (const auto& [clock, falls] : q.gold.clocks) {
    const auto other = q.steps ? q.gate.clocks.find(gate_name(q, clock)) : q.gate.clocks.begin();
    if (other == q.gate.clocks.end() || other->second == falls) continue;
    throw InputError(clock + ": one takes over when it rises, the other when it falls");
  }
}

void require_steps(const Question& q) {
  if (q.latency > 0) throw InputError("--latency: there are several clocks");
  for (const Side* side : {&q.gold, &q.gate}) {
    for (const std::string& clock : side->clocks_as_data) {
      throw InputError(clock + ": is read as data, and there are several clocks");
    }
  }
}

}  // namespace cosim::equiv
