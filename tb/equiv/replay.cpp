#include "tb/equiv/replay.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <deque>
#include <optional>

#include "tb/equiv/clocks.h"
#include "tb/equiv/misread.h"
#include "tb/equiv/simulator.h"
#include "tb/equiv/sources.h"
#include "tb/util/parallel.h"
#include "tb/util/process.h"

namespace cosim::equiv {
namespace {

using Lines = std::vector<std::vector<std::string>>;  // words of outputs, a line a clock

// `fill`: what a register begins as that may begin as anything.
Stimulus stimulus_of(const Question& q, const Answer& a, bool is_gate, char fill) {
  const Side& side = is_gate ? q.gate : q.gold;
  const auto own_name = [&](const std::string& port) {
    return is_gate ? gate_name(q, port) : port;
  };
  Stimulus s;
  s.steps = q.steps;
  s.tied = q.tied;
  const Row& first = a.clocks.front();
  for (const auto& [port, value] : first.inputs) {
    if (side.inputs.contains(own_name(port))) s.inputs.push_back(own_name(port));
  }
  for (const auto* rows : {&a.clocks, &a.after}) {
    for (const Row& row : *rows) {
      std::string bits;
      for (const auto& [port, value] : row.inputs) {
        if (side.inputs.contains(own_name(port))) bits += value;
      }
      std::replace(bits.begin(), bits.end(), '-', '0');
      if (s.rows.empty()) s.rows.push_back(at_rest(side, s));
      s.rows.push_back(bits);
    }
  }
  for (const auto& [port, value] : first.gold) s.outputs.push_back(own_name(port));
  std::string begins = is_gate ? a.gate_begins : a.gold_begins;
  std::ranges::replace(begins, 'x', fill);
  s.variables = variables_of(side, begins);
  for (const Assumption& one : is_gate ? std::vector<Assumption>{} : q.assumed) {
    s.modules += one.verilog;
    s.instances += fmt::format("  wire {0}_holds;\n  {0} {0}_of(.cosim_holds({0}_holds)", one.name);
    for (const std::string& port : one.ports) {
      const bool is_output = side.outputs.contains(port);
      // What an assumption names may be an output that the other one lacks.
      if (is_output && !first.gold.contains(port) &&
          std::ranges::find(s.wires, port) == s.wires.end()) {
        s.wires.push_back(port);
      }
      const auto tied = q.tied.find(port);
      s.instances += fmt::format(", .{}({})", verilog_name(port),
                                 tied != q.tied.end()
                                     ? fmt::format("{}'b{}", side.inputs.at(port), tied->second)
                                     : verilog_name((is_output ? "out_" : "in_") + port));
    }
    s.instances += ");\n";
    s.further.push_back(one.name + "_holds");
  }
  s.vcd = "yes";
  s.first_drawn = first_drawn(q, a);
  return s;
}

enum class Differs { yes, no, on_x };

// Whether an output that is compared differs on the last clock, and all that is assumed held.
Differs differs(const Question& q, const Answer& a, const Lines& gold, const Lines& gate) {
  const auto last = a.clocks.size(), then = last - static_cast<std::size_t>(q.latency);
  if (gold.size() < last || gate.size() < last) return Differs::no;
  const std::size_t outputs = a.clocks.back().gold.size();
  for (auto t = static_cast<std::size_t>(q.reset_clocks); t < last; ++t) {
    for (std::size_t i = 0; i < q.assumed.size(); ++i) {
      if (gold[t][outputs + i] != "1") return Differs::no;
    }
  }
  std::size_t at = 0;
  Differs found = Differs::no;
  for (const auto& [port, text] : a.clocks.back().gold) {
    const std::string &old = gold[then - 1].at(at), &now = gate[last - 1].at(at);
    ++at;
    if (std::ranges::find(a.differing, port) == a.differing.end()) continue;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '-' || old[i] == now[i]) continue;
      if (old[i] == '0' || old[i] == '1') return Differs::yes;
      found = Differs::on_x;
    }
  }
  return found;
}

// The values on the last clock, of the outputs that were to differ.
std::string values_of(const Answer& a, const Lines& gold, const Lines& gate) {
  std::string text;
  std::size_t at = 0;
  for (const auto& [port, value] : a.clocks.back().gold) {
    if (std::ranges::find(a.differing, port) != a.differing.end() &&
        gold.size() >= a.clocks.size() && gate.size() >= a.clocks.size()) {
      text += fmt::format("{}{} is {} in the old RTL and {} in the new", text.empty() ? "" : ", ",
                          port, gold[a.clocks.size() - 1][at], gate[a.clocks.size() - 1][at]);
    }
    ++at;
  }
  return text;
}

// Whether something in one of the RTLs may have any value.
bool has_unknown(const Question& q) {
  return std::ranges::any_of(std::array{&q.gold, &q.gate}, [](const Side* side) {
    return side->unknowns > 0 || std::ranges::any_of(side->registers, &Register::any);
  });
}

// What has no initial value begins in Verilator as 0, as 1 and by chance.
constexpr std::array beginnings{"0", "1", "2"};

Replay replay(const Question& q, const Answer& a, Simulator simulator, char fill = 'x') {
  const bool is_icarus = simulator == Simulator::icarus;
  std::optional<Program> programs[2];
  std::vector<Lines> lines[2];
  Shown shown[2];
  in_parallel(2, q.jobs, [&](std::uint64_t i) {
    const Side& side = i == 1 ? q.gate : q.gold;
    programs[i].emplace(side, stimulus_of(q, a, i == 1, fill), simulator, q.budget.ends());
    if (!programs[i]->why_not().empty()) return true;
    for (const char* begins : beginnings) {
      lines[i].push_back(programs[i]->run(q.budget.ends(), begins).clocks);
      if (is_icarus) break;
    }
    if (is_icarus) shown[i] = {lines[i].front(), programs[i]->wave()};
    return true;
  });
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& all = lines[i];
    if (!all.empty() && std::ranges::none_of(all, [](auto& l) { return l.empty(); })) continue;
    return {false,
            false,
            fmt::format("on the netlists: {} does not build the {} RTL", name_of(simulator),
                        i == 0 ? "old" : "new"),
            "",
            {},
            {}};
  }
  const std::string how = fmt::format("in {}", name_of(simulator));
  if (is_icarus) {
    const Differs is = differs(q, a, lines[0][0], lines[1][0]);
    if (is == Differs::yes) return {true, false, how, "", std::move(shown[0]), std::move(shown[1])};
    return {false, true, how, values_of(a, lines[0][0], lines[1][0]), {}, {}};
  }
  for (std::size_t o = 0; o < beginnings.size(); ++o) {
    for (std::size_t n = 0; n < beginnings.size(); ++n) {
      if (differs(q, a, lines[0][o], lines[1][n]) != Differs::yes) continue;
      Replay is{true, false, how, "", {lines[0][o], ""}, {lines[1][n], ""}};
      try {
        in_parallel(2, q.jobs, [&](std::uint64_t i) {
          programs[i]->run(q.budget.ends(), beginnings[i == 0 ? o : n]);
          (i == 0 ? is.gold : is.gate).vcd = programs[i]->wave();
          return true;
        });
      } catch (const OutOfTime&) {  // it is shown all the same
      }
      return is;
    }
  }
  if (has_unknown(q)) {
    return {false, false, "on the netlists: Verilator has other values for what is x", "", {}, {}};
  }
  return {false, true, how, values_of(a, lines[0][0], lines[1][0]), {}, {}};
}

}  // namespace

Replay replayed(const Question& q, const Answer& a) {
  for (const Side* s : {&q.gold, &q.gate}) {
    if (!s->clocks_as_data.empty()) {
      return {false, false, "on the netlists: the clock is read as data", "", {}, {}};
    }
  }
  try {
    Replay first = replay(q, a, Simulator::icarus);
    // The stimulus tells them apart whatever the old RTL begins as, but an x there hides it: m[x]
    // of a memory is x though all words differ from what the new one says.
    if (first.refuted && a.gold_begins.find('x') != std::string::npos) {
      const Replay zeros = replay(q, a, Simulator::icarus, '0');
      if (zeros.shown && replay(q, a, Simulator::icarus, '1').shown) first = zeros;
    }
    // Icarus Verilog misreads expressions on wider ports. Verilator has other values for what is x.
    const auto misreads = [](const Side* side) {
      return may_be_cut_on_ports(sources_of(side->files()));
    };
    const std::array sides{&q.gold, &q.gate};
    const bool is_refuted =
        first.refuted && (has_unknown(q) || std::ranges::none_of(sides, misreads));
    if (first.shown || is_refuted || !q.verilator || !is_installed("verilator")) return first;
    return replay(q, a, Simulator::verilator);
  } catch (const OutOfTime&) {
    return {false, false, "on the netlists: no time was left for a simulator", "", {}, {}};
  }
}

}  // namespace cosim::equiv
