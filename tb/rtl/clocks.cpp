#include "tb/rtl/clocks.h"

#include <algorithm>

#include "model/core/input_error.h"

namespace cosim::rtl {
namespace {

std::string joined_by_and(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " and ") + name;
  return text;
}

std::vector<std::string> nets_of_edges(const std::vector<EdgeOf>& edges) {
  std::vector<std::string> all;
  for (const EdgeOf& edge : edges) all.push_back(edge.net);
  return all;
}

// What is said of a clock that is no input: what makes it too, a clock gate or a divider that is an
// instance.
std::string no_clock(const Elaborated& design, const std::string& net) {
  std::string from = net;
  std::size_t most = 0;
  for (const auto& [name, is] : design.design.nets()) {
    const auto carriers = design.carried.carriers(name);
    if (!carriers.contains(net) || carriers.size() <= most) continue;
    from = name;
    most = carriers.size();
  }
  return "its clock is " + net + (from != net ? ", made by " + from : "") + ", which is no input";
}

// The input on whose edges a process's registers change, "" where that is not to be told: of one
// edge that one, and of several the one that it does not read, for a reset it does.
std::string likely_clock(const Elaborated& design, const Process& p) {
  const auto nets = nets_of_edges(p.edges);
  auto left = nets;
  std::erase_if(left, [&](const std::string& net) { return p.tested.contains(net); });
  if (left.size() != 1) left = nets;
  if (left.size() != 1) return "";
  const std::string input = design.input_of(left[0], false);
  if (input.empty()) throw InputError(p.first_held() + ": " + no_clock(design, left[0]));
  return input;
}

}  // namespace

void require_one_edge(const Elaborated& design, const Process& p) {
  const auto input_or_net = [&](const EdgeOf& edge) {
    const std::string input = design.input_of(edge.net, false);
    return input.empty() ? edge.net : input;
  };
  std::map<std::string, std::string> ways;
  for (const EdgeOf& edge : p.edges) {
    const std::string net = input_or_net(edge);
    if (edge.way == "BOTH" || ways.try_emplace(net, edge.way).first->second != edge.way) {
      throw InputError(p.first_held() + ": a register on both edges of " + net);
    }
  }
}

std::vector<std::string> found_clocks(const Elaborated& design) {
  std::set<std::string> clocks;
  std::vector<const Process*> open;
  for (const Process& p : design.clocked) {
    const std::string clock = likely_clock(design, p);
    if (clock.empty()) {
      open.push_back(&p);
    } else {
      clocks.insert(clock);
    }
  }
  for (const Process* p : open) {
    const bool has_clock = std::ranges::any_of(p->edges, [&](const EdgeOf& edge) {
      return clocks.contains(design.input_of(edge.net, false));
    });
    if (has_clock) continue;
    throw InputError(p->first_held() + ": a register on the edges of " +
                     joined_by_and(nets_of_edges(p->edges)) + ": --clock says which is its clock");
  }
  return {clocks.begin(), clocks.end()};
}

std::map<std::string, std::string> give_clocks(Elaborated& design,
                                               const std::vector<std::string>& clocks,
                                               bool is_one) {
  std::map<std::string, std::string> ways, first;
  for (Process& p : design.clocked) {
    const std::string& named = p.first_held();
    std::vector<EdgeOf> own;
    for (const EdgeOf& edge : p.edges) {
      const std::string input = design.input_of(edge.net, false);
      if (std::ranges::count(clocks, input) != 0) {
        own.push_back({edge.way, input});
      } else {
        p.others.push_back(edge);
      }
    }
    if (own.size() != 1) {
      const bool has_another = !p.others.empty();
      const std::string net = has_another ? p.others[0].net : joined_by_and(nets_of_edges(own));
      if (p.others.size() == 1 && p.others[0].way == "NEG") {
        throw InputError(named + ": a register on the falling edge of " + net);
      }
      const bool is_no_input =
          design.input_of(net, false).empty() && design.input_of(net, true).empty();
      if (net.find(' ') == net.npos && is_no_input) {
        throw InputError(named + ": " + no_clock(design, net));
      }
      throw InputError(named + ": its clock is " + net + ", and " +
                       (clocks.size() > 1 ? "those of the design are " : "that of the design is ") +
                       joined_by_and(clocks));
    }
    const auto& [way, clock] = own[0];
    if (way != "POS" && is_one) {
      throw InputError(named + ": a register on the falling edge of " + clock);
    }
    const auto known = ways.try_emplace(clock, way).first;
    first.try_emplace(clock, named);
    if (known->second != way) {
      throw InputError(named + " and " + first[clock] + ": registers on both edges of " + clock);
    }
    p.clock = clock;
  }
  for (const std::string& clock : clocks) {
    const long bits = design.design.net(clock)->bits();
    if (bits != 1) {
      throw InputError(clock + ": a clock of " + std::to_string(bits) + " bits");
    }
  }
  return ways;
}

void require_plain(const Elaborated& design, const std::string& clock) {
  for (const auto& [net, low] : design.carried.carriers(clock)) {
    if (design.outputs.contains(net)) {
      throw InputError(net + ": an output that is the clock " + clock);
    }
    if (design.reads.is_value(net)) throw InputError(net + ": a clock that is read as a value");
  }
}

}  // namespace cosim::rtl
