// First what signal correspondence gives (correspondence.h). Where that is not all, property
// directed reachability (pdr of abc) has the graph as it is with those signals merged, and what it
// learns of the registers that are left, a set of clauses, is read and asked about.
#include "tb/proof/invariant.h"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "tb/proof/cnf.h"
#include "tb/proof/correspondence.h"
#include "tb/support/output_file.h"
#include "tb/support/process.h"
#include "tb/support/read_file.h"
#include "tb/support/words.h"

namespace cosim::proof {
namespace {

using Clock = std::chrono::steady_clock;
using Lit = Aig::Lit;
using Lits = std::vector<Lit>;

// States that are never reached: these registers of a graph have these values.
using Cube = std::vector<std::pair<std::size_t, bool>>;

// The graph with what is the same merged.
struct Merged {
  Aig graph;
  Lit bad = 0;
};

Merged merged(const Aig& graph, Lit bad, const Same& same) {
  Merged all;
  const auto leaf = [&](std::size_t n) {
    const Aig::Node& node = graph.nodes()[n];
    return node.kind == Aig::Kind::latch ? all.graph.latch(graph.registers()[node.a].first)
                                         : all.graph.input();
  };
  const Frame now = frame_of(graph, same, all.graph, leaf);
  const Lits next = next_state(graph, now);
  for (std::size_t i = 0; i < next.size(); ++i) {
    const std::size_t n = graph.registers()[i].node;
    if (same[n] / 2 == n) all.graph.next(now.values[n], next[i]);
  }
  all.bad = now.values[bad / 2] ^ (bad & 1U);
  return all;
}

// A file of pdr: a line a cube, a column a register, as in AIGER.
std::vector<Cube> cubes_in(const std::string& pla, const Aig& graph) {
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
      if (word[i] == '-' || registers[i] >= graph.latches()) continue;
      cube.emplace_back(registers[i], (word[i] == '1') != graph.registers()[registers[i]].first);
    }
  }
  return cubes;
}

std::vector<Cube> learnt(const Merged& of, Clock::time_point until) {
  const Scratch scratch;
  OutputFile file((scratch.path() / "asked.aig").string());
  file.text(of.graph.aiger(of.bad));
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
bool begins_outside(const std::vector<Cube>& cubes, const Aig& graph) {
  return std::all_of(cubes.begin(), cubes.end(), [&](const Cube& cube) {
    return std::any_of(cube.begin(), cube.end(), [&](const auto& one) {
      return graph.registers()[one.first].first != one.second;
    });
  });
}

// Whether a clock that begins outside of the cubes has no `bad`, and ends outside of them.
Answer leaves(const Merged& of, const std::vector<Cube>& cubes, Clock::time_point until) {
  Aig logic;
  Same own(of.graph.nodes().size());
  for (std::size_t n = 0; n < own.size(); ++n) own[n] = static_cast<Lit>(2 * n);
  const Frame now = frame_of(of.graph, own, logic, [&](std::size_t) { return logic.input(); });
  Lits state;
  for (const Aig::Latch& latch : of.graph.registers()) state.push_back(now.values[latch.node]);
  const Lits next = next_state(of.graph, now);
  Lits all, any{now.values[of.bad / 2] ^ (of.bad & 1U)};
  for (const Cube& cube : cubes) {
    Lit is_in = 1, comes_in = 1;
    for (const auto& [i, value] : cube) {
      is_in = logic.and_of(is_in, state[i] ^ (value ? 0U : 1U));
      comes_in = logic.and_of(comes_in, next[i] ^ (value ? 0U : 1U));
    }
    all.push_back(Aig::inverted(is_in));
    any.push_back(comes_in);
  }
  return satisfy(logic, all, any, until).answer;
}

}  // namespace

Invariant invariant_of(const Aig& graph, Lit bad, Clock::time_point until) {
  Invariant invariant;
  const auto began = Clock::now();
  const auto same = corresponding(graph, bad, began + (until - began) / 2);
  Same merging(graph.nodes().size());
  for (std::size_t n = 0; n < merging.size(); ++n) {
    merging[n] = same ? (*same)[n] : static_cast<Lit>(2 * n);
    if (merging[n] / 2 != n) ++invariant.equalities;
  }
  const Merged left = merged(graph, bad, merging);
  std::vector<Cube> cubes;
  if (left.bad != 0) {
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
