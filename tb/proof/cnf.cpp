// Three clauses for each gate that is read (Tseitin's transformation), in the DIMACS format.
#include "tb/proof/cnf.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "tb/support/output_file.h"
#include "tb/support/process.h"

namespace cosim::proof {
namespace {

using Lit = Aig::Lit;
using Lits = std::vector<Lit>;

// The nodes that these are made of.
std::vector<bool> cone(const Aig& logic, const Lits& all, const Lits& any) {
  const auto& nodes = logic.nodes();
  std::vector<bool> read(nodes.size());
  for (const Lits* lits : {&all, &any}) {
    for (const Lit lit : *lits) read[lit / 2] = true;
  }
  for (std::size_t n = nodes.size(); n-- > 0;) {
    if (read[n] && nodes[n].kind == Aig::Kind::both) {
      read[nodes[n].a / 2] = read[nodes[n].b / 2] = true;
    }
  }
  return read;
}

// Node n is variable n + 1.
std::string dimacs(const Aig& logic, const Lits& all, const Lits& any) {
  std::string clauses;
  std::size_t count = 0;
  const auto put = [&](const Lits& clause) {
    for (const Lit lit : clause) {
      clauses += fmt::format("{}{} ", (lit & 1U) != 0 ? "-" : "", lit / 2 + 1);
    }
    clauses += "0\n";
    ++count;
  };
  put({1});
  const std::vector<bool> read = cone(logic, all, any);
  const auto& nodes = logic.nodes();
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (!read[n] || nodes[n].kind != Aig::Kind::both) continue;
    const Lit out = static_cast<Lit>(2 * n), a = nodes[n].a, b = nodes[n].b;
    put({Aig::inverted(out), a});
    put({Aig::inverted(out), b});
    put({out, Aig::inverted(a), Aig::inverted(b)});
  }
  for (const Lit lit : all) put({lit});
  put(any);
  return fmt::format("p cnf {} {}\n", nodes.size(), count) + clauses;
}

}  // namespace

std::string sat_solver() {
  for (const char* program : {"cadical", "z3"}) {
    if (is_installed(program)) return program;
  }
  return "";
}

Satisfied satisfy(const Aig& logic, const Lits& all, const Lits& any,
                  std::chrono::steady_clock::time_point until) {
  Satisfied satisfied;
  const auto is_false = [](Lit lit) { return lit == 0; };
  if (std::any_of(all.begin(), all.end(), is_false) ||
      std::all_of(any.begin(), any.end(), is_false)) {
    satisfied.answer = Answer::unsat;
    return satisfied;
  }
  const std::string solver = sat_solver();
  satisfied.answer = Answer::missing;
  if (solver.empty()) return satisfied;
  const Scratch scratch;
  const std::string name = (scratch.path() / "asked.cnf").string();
  OutputFile file(name);
  file.text(dimacs(logic, all, any));
  file.close();
  const Ended ended = run_until({solver, solver == "z3" ? "-dimacs" : "-q", name}, until);
  satisfied.answer = ended.timed_out ? Answer::timed_out : Answer::failed;
  if (ended.timed_out) return satisfied;

  std::vector<bool> is_one(logic.nodes().size() + 2);
  std::istringstream lines(ended.text);
  for (std::string line; std::getline(lines, line);) {
    if (line == "s UNSATISFIABLE") satisfied.answer = Answer::unsat;
    if (line == "s SATISFIABLE") satisfied.answer = Answer::sat;
    if (!line.starts_with("v ")) continue;
    std::istringstream numbers(line.substr(2));
    for (long number = 0; numbers >> number && number != 0;) {
      const auto variable = static_cast<std::size_t>(std::abs(number));
      if (variable < is_one.size()) is_one[variable] = number > 0;
    }
  }
  for (std::size_t n = 0; n < logic.nodes().size(); ++n) {
    if (logic.nodes()[n].kind == Aig::Kind::input) satisfied.inputs.push_back(is_one[n + 1]);
  }
  return satisfied;
}

}  // namespace cosim::proof
