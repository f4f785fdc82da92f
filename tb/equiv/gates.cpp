// A side as gates: yosys maps its cells to them and writes AIGER, which is read here.
#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <sstream>

#include "model/core/input_error.h"
#include "tb/equiv/netlist.h"
#include "tb/equiv/side.h"
#include "tb/proof/steps.h"
#include "tb/support/json.h"
#include "tb/support/output_file.h"
#include "tb/support/quoted.h"
#include "tb/support/read_file.h"

namespace cosim::equiv {
namespace {

namespace fs = std::filesystem;
using Lit = proof::Aig::Lit;

// Memories as ports of the module.
std::string with_ports_for_memories(Json netlist) {
  Json& module = top_of(netlist);
  std::size_t n = 0;
  Json cells = module.at("cells");
  for (auto& [name, cell] : module.at("cells").items()) {
    if (cell.at("type") != "$mem_v2") continue;
    for (const char* port : {"RD_DATA", "RD_ADDR", "WR_EN", "WR_ADDR", "WR_DATA"}) {
      const bool comes = port == std::string_view("RD_DATA");
      module["ports"][memory_port(n, port)] = {{"direction", comes ? "input" : "output"},
                                               {"bits", cell.at("connections").at(port)}};
    }
    cells.erase(name);
    ++n;
  }
  module["cells"] = std::move(cells);
  return netlist.dump();
}

// A bit of a port as AIGER names it: "data[3]", or "data" where it has one.
Name bit_of(const std::string& text, const std::map<std::string, int>& ports) {
  const std::size_t at = text.rfind('[');
  const auto port = ports.find(text);
  if (at == std::string::npos || (port != ports.end() && port->second == 1)) return {text, 0};
  return {text.substr(0, at), std::stoi(text.substr(at + 1))};
}

}  // namespace

std::string memory_port(std::size_t memory, const char* port) {
  return fmt::format("cosim.memory{}.{}", memory, port);
}

// Between an input and an output that are one net: newer versions of yosys write no map of that.
// The two inverters are no gates in AIGER.
constexpr const char* buffer = R"(module cosim_buffer(input A, output Y);
  wire n;
  \$_NOT_ first(.A(A), .Y(n));
  \$_NOT_ second(.A(n), .Y(Y));
endmodule
)";

void Side::make_gates(Memories how, bool steps, const Budget& budget) {
  const fs::path own = scratch_->path();
  const std::string name = word_for_yosys(own.string());
  std::string script = fmt::format("read_rtlil {}/top.il; memory_map\n", name);
  if (how == Memories::cut && !memories.empty()) {
    write_file((own / "cut.json").string(),
               with_ports_for_memories(json_of(read_file((own / "top.json").string()))));
    script = fmt::format("read_json {}/cut.json\n", name);
  }
  if (steps) {
    proof::Source source;
    source.clocks_are_inputs = true;
    // It names its file as it is.
    script += "opt_clean" + proof::step_commands(source, name) + "\n";
  }
  write_file((own / "buffer.v").string(), buffer);
  // What is of no use then is left where it is: to clean so many gates takes as long as to make
  // them.
  script += fmt::format(
      "opt -full; async2sync; dffunmap; opt_clean; simplemap; techmap; dffunmap\n"
      "opt_clean; setundef -anyseq; aigmap\n"
      "insbuf -buf cosim_buffer A Y i:* %co1 o:* %i; techmap -map {0}/buffer.v\n"
      "write_aiger -ascii -symbols -no-startoffset -vmap {0}/top.map {0}/top.aag\n",
      name);
  yosys(script, budget);
  for (auto* all : {&in_, &state_, &next_, &out_}) all->clear();
  in_names_.clear();
  out_names_.clear();
  registers.clear();
  unknowns = 0;
  read(read_file((own / "top.aag").string()), read_file((own / "top.map").string()));
}

void Side::read(const std::string& aiger, const std::string& map) {
  std::istringstream in(aiger);
  std::string word;
  std::size_t top = 0, inputs_count = 0, latches = 0, out_count = 0, gates = 0;
  in >> word >> top >> inputs_count >> latches >> out_count >> gates;
  in_.resize(inputs_count);
  out_.resize(out_count);
  gates_.resize(gates);
  for (unsigned& lit : in_) in >> lit;
  std::string line;
  std::getline(in, line);
  std::map<unsigned, std::size_t> register_of;
  for (std::size_t i = 0; i < latches; ++i) {
    std::getline(in, line);
    std::istringstream numbers(line);
    unsigned lit = 0, next = 0, first = 0;
    numbers >> lit >> next >> first;
    register_of[lit] = i;
    state_.push_back(lit);
    next_.push_back(next);
    registers.push_back({{}, first > 1, first == 1, {}});
  }
  for (unsigned& lit : out_) in >> lit;
  for (Gate& gate : gates_) in >> gate.out >> gate.a >> gate.b;
  for (std::string line_of; in >> word && word != "c" && std::getline(in, line_of);) {
    const std::size_t number = std::stoul(word.substr(1));
    std::istringstream names(line_of);
    for (std::string name; names >> name;) {
      if (word.front() == 'i') in_names_[number] = bit_of(name, inputs);
      if (word.front() == 'o') out_names_.emplace(number, bit_of(name, outputs));
    }
  }
  // The gates that do not depend on constants alone, or on one thing and a constant.
  std::map<unsigned, Gate> made;
  std::vector<unsigned> folded(2 * top + 2);
  std::iota(folded.begin(), folded.end(), 0U);
  for (const Gate& gate : gates_) {
    const unsigned a = std::min(folded.at(gate.a), folded.at(gate.b));
    const unsigned b = std::max(folded.at(gate.a), folded.at(gate.b));
    const bool is_gate = a > 1 && a != b && a != (b ^ 1U);
    const unsigned is = is_gate ? gate.out : a == 0 || a == (b ^ 1U) ? 0U : b;
    folded.at(gate.out) = is;
    folded.at(gate.out ^ 1U) = is ^ 1U;
    if (is_gate) made[gate.out] = {gate.out, a, b};
  }
  // A register with an asynchronous reset lies behind the gates that have its name: it and the
  // reset, or it and the reset, or the reset.
  const auto behind = [&](unsigned at) {
    std::set<unsigned> leaves{at};
    constexpr int levels = 2;
    for (int level = 0; level < levels; ++level) {
      for (const unsigned leaf : std::set<unsigned>(leaves)) {
        const auto gate = made.find(leaf);
        if (gate == made.end()) continue;
        leaves.erase(leaf);
        leaves.insert({gate->second.a & ~1U, gate->second.b & ~1U});
      }
    }
    if (leaves.size() > 2) return at;
    const auto is_register = [&](unsigned leaf) { return register_of.contains(leaf); };
    if (std::ranges::count_if(leaves, is_register) != 1) return at;
    return *std::ranges::find_if(leaves, is_register);
  };
  std::istringstream lines(map);
  std::string kind, name;
  std::size_t lit = 0;
  int bit = 0;
  while (lines >> kind >> lit >> bit && std::getline(lines >> std::ws, name)) {
    if (kind != "wire" || name.starts_with("$")) continue;
    const unsigned at = behind(folded.at(lit) & ~1U);
    const auto found = register_of.find(at);
    if (found == register_of.end()) continue;
    Register& is = registers[found->second];
    if (at == lit) is.nets.insert({name, bit});
    Name& own = is.name;
    if (own.first.empty() || (at == lit && Name{name, bit} < own)) own = {name, bit};
  }
  for (std::size_t i = 0; i < in_.size(); ++i) unknowns += in_names_.contains(i) ? 0U : 1U;
}

void Side::name_as(const Side& other) {
  std::map<Name, Name> theirs;
  for (const Register& r : other.registers) {
    for (const Name& net : r.nets) theirs.emplace(net, r.name);
  }
  for (Register& r : registers) {
    const auto same =
        std::ranges::find_if(r.nets, [&](const Name& net) { return theirs.contains(net); });
    if (same != r.nets.end()) r.name = theirs.at(*same);
  }
}

Side::Made Side::make(proof::Aig& graph, const std::function<Lit(const Name&)>& input,
                      const std::vector<Lit>& unknown, const std::vector<Lit>& state) const {
  std::vector<Lit> value(2 * (in_.size() + state_.size() + gates_.size()) + 2, 0);
  const auto of = [&](unsigned lit) { return value[lit / 2] ^ (lit & 1U); };
  std::size_t next_unknown = 0;
  for (std::size_t i = 0; i < in_.size(); ++i) {
    const auto name = in_names_.find(i);
    value[in_[i] / 2] = name == in_names_.end() ? unknown[next_unknown++] : input(name->second);
  }
  for (std::size_t i = 0; i < state_.size(); ++i) value[state_[i] / 2] = state[i];
  for (const Gate& gate : gates_) value[gate.out / 2] = graph.and_of(of(gate.a), of(gate.b));
  Made made;
  for (const auto& [i, name] : out_names_) made.outputs[name] = of(out_[i]);
  for (const unsigned next : next_) made.next.push_back(of(next));
  return made;
}

}  // namespace cosim::equiv
