// First what signal correspondence gives (correspondence.h). Where that is not all, property
// directed reachability (pdr of abc) has the graph as it is with those signals merged, and what it
// learns of the registers that are left, a set of clauses, is read and asked about.
#include "tb/proof/invariant.h"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "tb/proof/correspondence.h"
#include "tb/proof/sat.h"
#include "tb/util/output_file.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::proof {
namespace {

using Clock = std::chrono::steady_clock;
using nets::Bit;
using nets::Bits;
using nets::gate_bit;
using nets::no;
using nets::yes;

// States that are never reached: these registers of a graph have these values.
using Cube = std::vector<std::pair<std::size_t, bool>>;

// The graph with what is the same merged.
struct Merged {
  nets::Graph graph;
  Bit bad = no;
};

Merged merged(const nets::Graph& graph, Bit bad, const Same& same) {
  Merged all;
  const auto leaf = [&](std::size_t n) {
    const nets::Graph::Made& node = graph.gates()[n];
    return node.kind == nets::Gate::latch ? all.graph.latch(graph.latches()[node.number].first)
                                          : all.graph.input();
  };
  const Frame now = frame_of(graph, same, all.graph, leaf);
  const Bits next = next_state(graph, now);
  for (std::size_t i = 0; i < next.size(); ++i) {
    const std::size_t n = graph.latches()[i].now.gate();
    if (same[n].gate() == n) all.graph.next(now.values[n], next[i]);
  }
  all.bad = placed_at(now.values, bad);
  return all;
}

// A file of pdr: a line a cube, a column a register, as in AIGER.
std::vector<Cube> cubes_in(const std::string& pla, const nets::Graph& graph) {
  std::vector<Cube> cubes;
  std::vector<std::size_t> registers;
  std::istringstream lines(pla);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == ".ilb") {
      for (std::string name; words >> name;) registers.push_back(std::stoul(name.substr(1)));
    }
    if (word.find_first_not_of("01-") != std::string::npos || word.empty()) continue;
    Cube& cube = cubes.emplace_back();
    for (std::size_t i = 0; i < std::min(word.size(), registers.size()); ++i) {
      if (word[i] == '-' || registers[i] >= graph.latches().size()) continue;
      cube.emplace_back(registers[i], (word[i] == '1') != graph.latches()[registers[i]].first);
    }
  }
  return cubes;
}

std::vector<Cube> learnt(const Merged& of, Clock::time_point until) {
  const Scratch scratch;
  OutputFile file((scratch.path() / "asked.aig").string());
  file.text(aiger(of.graph, {of.bad}));
  file.close();
  const std::string found = (scratch.path() / "invariant").string();
  run_until({"env", "-C", scratch.path().string(), "yosys-abc", "-s", "-q",
             "read_aiger asked.aig; strash; pdr -d -I invariant"},
            until);
  std::error_code error;
  if (!std::filesystem::exists(found, error)) return {};
  return cubes_in(read_file(found), of.graph);
}

// Whether none of the cubes holds the first state.
bool begins_outside(const std::vector<Cube>& cubes, const nets::Graph& graph) {
  return std::all_of(cubes.begin(), cubes.end(), [&](const Cube& cube) {
    return std::any_of(cube.begin(), cube.end(), [&](const auto& one) {
      return graph.latches()[one.first].first != one.second;
    });
  });
}

// Whether a clock that begins outside of the cubes has no `bad`, and ends outside of them.
Answer leaves(const Merged& of, const std::vector<Cube>& cubes, Clock::time_point until) {
  nets::Graph logic;
  Same own(of.graph.gates().size());
  for (std::size_t n = 0; n < own.size(); ++n) own[n] = gate_bit(n);
  const Frame now = frame_of(of.graph, own, logic, [&](std::size_t) { return logic.input(); });
  Bits state;
  for (const nets::Graph::Latch& latch : of.graph.latches())
    state.push_back(now.values[latch.now.gate()]);
  const Bits next = next_state(of.graph, now);
  Bits all, any{placed_at(now.values, of.bad)};
  for (const Cube& cube : cubes) {
    Bit is_in = yes, comes_in = yes;
    for (const auto& [i, value] : cube) {
      is_in = logic.and_of(is_in, state[i] ^ !value);
      comes_in = logic.and_of(comes_in, next[i] ^ !value);
    }
    all.push_back(!is_in);
    any.push_back(comes_in);
  }
  return satisfy(logic, all, any, until).answer;
}

}  // namespace

Invariant invariant_of(const nets::Graph& graph, Bit bad, Clock::time_point until) {
  Invariant invariant;
  const auto began = Clock::now();
  const auto same = corresponding(graph, bad, began + (until - began) / 2);
  Same merging(graph.gates().size());
  for (std::size_t n = 0; n < merging.size(); ++n) {
    merging[n] = same ? (*same)[n] : gate_bit(n);
    if (merging[n].gate() != n) ++invariant.equalities;
  }
  const Merged left = merged(graph, bad, merging);
  std::vector<Cube> cubes;
  if (left.bad != nets::no) {
    cubes = learnt(left, until);
    invariant.clauses = cubes.size();
  }
  if (begins_outside(cubes, left.graph) && leaves(left, cubes, until) == Answer::unsat) {
    invariant.is_checked = true;
  } else {
    invariant.missing = "no invariant in time";
  }
  return invariant;
}

std::string to_text(const Invariant& invariant) {
  if (!invariant.is_checked) return "that rests on abc alone: " + invariant.missing;
  std::string what = count(invariant.equalities, "equal signal");
  if (invariant.clauses > 0) what += " and " + count(invariant.clauses, "clause");
  return "checked by cadical: " + what;
}

}  // namespace cosim::proof
