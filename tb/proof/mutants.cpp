// Two copies of the RTL, one with the mutant, from the same state (register correspondence by
// name): one step of induction. Flip-flops that are no register's are free on both sides.
#include "tb/proof/mutants.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "tb/proof/located.h"
#include "tb/proof/mutant_nets.h"
#include "tb/proof/steps.h"
#include "tb/proof/terms.h"
#include "tb/support/process.h"
#include "tb/support/quoted.h"
#include "tb/support/read_file.h"

namespace cosim::proof {
namespace {

namespace fs = std::filesystem;

Expression differ(const Expression& a, const Expression& b) { return negation(equal(a, b)); }
Script declared(const MachineFormula& m) {
  Script script("QF_BV");
  for (const Wire& w : m.inputs) script.declare(w.code.text(), w.code.sort());
  for (const Wire& w : m.state) script.declare(w.code.text(), w.code.sort());
  return script;
}

// One of the two machines in a question: its inputs are the model's; its flip-flops are what the
// nets of the registers are given to hold, or free.
class Side {
 public:
  Side(const char* side, const MachineFormula& m, const Rtl& rtl, const std::vector<Wire>& given,
       Script& script)
      : rtl_(rtl), script_(script) {
    std::vector<std::optional<Expression>> known(rtl.free().size());
    // A cell that is whole flip-flops gives them their values; of any other its wire is assumed.
    const auto know = [&](const Wire& w, const RtlCell& cell, bool is_register) {
      const auto pieces = pieces_of(rtl, cell);
      int left = cell.width;
      for (const Piece& p : pieces) {
        const Rtl::Free& f = rtl.free()[p.free];
        if (f.after.empty() == is_register || known[p.free] || p.width != f.width) return false;
        left -= p.width;
      }
      if (left != 0) return false;
      left = cell.width;
      for (const Piece& p : pieces) known[p.free] = cut(w.code, left -= p.width, p.width);
      return true;
    };
    std::vector<std::pair<Expression, Expression>> assumed;
    const auto give = [&](const char* kind, const std::vector<Wire>& table, bool is_register) {
      const auto cells = located(rtl, m.design, kind, table);
      for (std::size_t i = 0; i < table.size(); ++i) {
        if (know(table[i], cells[i], is_register)) continue;
        assumed.emplace_back(during(rtl, cells[i]), table[i].code);
      }
    };
    give("input", m.inputs, false);
    std::vector<Wire> held = given;
    for (Wire& w : held) {
      if (!w.when) continue;  // at other times it holds anything, and not the same on both sides
      const Expression any = script.declare(term_of(side, w.field), w.code.sort());
      w.code = {"ite", w.code.sort(), {*w.when, w.code, any}};
    }
    give("register", held, true);
    for (std::size_t i = 0; i < known.size(); ++i) {
      const Rtl::Free& f = rtl.free()[i];
      if (known[i]) {
        script.define(f.symbol, as_sort(*known[i], f.sort()));
      } else {
        script.declare(f.symbol, f.sort());
      }
    }
    script.add(rtl.definitions());
    for (const auto& [wire, code] : assumed) script.assume(equal(wire, code));
  }

  std::vector<Expression> outputs(const MachineFormula& m) const {
    std::vector<Expression> all;
    for (const RtlCell& c : located(rtl_, m.design, "output", m.outputs)) {
      all.push_back(during(rtl_, c));
    }
    return all;
  }

  // What the registers' nets hold after the clock.
  std::vector<Expression> after(const MachineFormula& m) {
    std::vector<Expression> all;
    for (const RtlCell& c : located(rtl_, m.design, "register", m.registers)) {
      const auto pieces = pieces_of(rtl_, c);
      const bool held = !pieces.empty() && std::none_of(pieces.begin(), pieces.end(), [&](Piece p) {
        return rtl_.free()[p.free].after.empty();
      });
      all.push_back(held ? proof::after(rtl_, c) : with_next_clock(c));
    }
    return all;
  }

 private:
  // More than the flip-flops makes the net: it takes the clock after to say.
  Expression with_next_clock(const RtlCell& cell) {
    if (!next_clock_) {
      for (const Rtl::Free& free : rtl_.free()) {
        if (free.after.empty()) {
          script_.declare(on_next_clock(free.symbol), free.sort());
        } else {
          script_.define(on_next_clock(free.symbol), {free.after, free.sort()});
        }
      }
      script_.add(on_next_clock(rtl_.definitions()));
      next_clock_ = true;
    }
    return on_next_clock(during(rtl_, cell));
  }

  const Rtl& rtl_;
  Script& script_;
  bool next_clock_ = false;
};

Claim asked(const std::string& what, const std::string& asks, Script script,
            const Expression& wrong) {
  script.ask(wrong);
  return {what, Answer::unsat, {{{asks}, script.text()}}, {}};
}

// By module, what yosys wrote of it.
std::map<std::string, std::string> modules_in(const fs::path& file) {
  std::istringstream stream(read_file(file.string()));
  std::map<std::string, std::string> all;
  const std::string mark = "; yosys-smt2-module ";
  std::string name;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with(mark)) name = line.substr(mark.size());
    all[name] += line + '\n';
  }
  return all;
}

// Flip-flops by name, with whether they are clocked by an input's rising edge, its falling one, or
// in another way.
enum class Edge { rising, falling, other };
std::map<std::string, Edge> clocks_in(const fs::path& stem) {
  std::map<std::string, Edge> all;
  const auto read = [&](const char* list, Edge edge) {
    std::istringstream stream(read_file(stem.string() + list));
    for (std::string line; std::getline(stream, line);) all[line.substr(line.find('/'))] = edge;
  };
  read(".all", Edge::other);
  read(".rising", Edge::rising);
  read(".falling", Edge::falling);
  return all;
}

}  // namespace

Claim reached_claim(const MachineFormula& m, const nets::Model* model) {
  Script script = declared(m);
  for (const auto* all : {&m.invariant, &m.reached, &m.legal}) {
    for (const Named& n : *all) script.assume(n.condition);
  }
  Expression wrong = truth(false);
  for (const auto* all :
       {&m.invariant_after, &m.reached_after, &m.invariant_in_reset, &m.reached_in_reset}) {
    for (const Named& n : *all) wrong = disjunction(wrong, negation(n.condition));
  }
  Claim claim = asked("what is reached stays so", "any clock", script, wrong);
  if (model != nullptr) claim.nets = std::make_shared<const NetQuestions>(nets_of_reached(*model));
  return claim;
}

Mutants::Mutants(const MachineFormula& machine, const fs::path& verilog,
                 const std::vector<unsigned>& numbers)
    : machine_(machine) {
  const Scratch scratch;
  const auto in_scratch = [&](const std::string& name) { return (scratch.path() / name).string(); };
  std::string kept = "w:*_q";
  const Source source = read_for(machine, {});
  for (const std::string& net : source.kept) kept += kept_net(net);
  // Before prep for registers that nothing reads, after it for those it makes of memories.
  std::string commands = fmt::format(
      "read_verilog {0}; setattr -set keep 1 {1}; prep -flatten -nomem -auto-top; "
      "memory_collect; memory_map; rename -top machine; setattr -set keep 1 {1}{2}; "
      "async2sync; dffunmap; setundef -anyseq; ",
      file_for_yosys(verilog), kept, step_commands(source, scratch.path()));
  std::vector<unsigned> all{0};
  all.insert(all.end(), numbers.begin(), numbers.end());
  for (const unsigned k : all) {
    commands += fmt::format(
        "copy machine m{0}; cd m{0}; delete -input mutsel; connect -set mutsel 16'd{0}; opt_expr; "
        "opt_clean -purge; select -write {1}.all t:$dff; "
        "select -write {1}.rising t:$dff i:* %co1:+$dff[CLK] %i r:CLK_POLARITY=1'b1 %i; "
        "select -write {1}.falling t:$dff i:* %co1:+$dff[CLK] %i r:CLK_POLARITY=1'b1 %d; cd ..; ",
        k, in_scratch(fmt::format("m{}", k)));
  }
  run_yosys(commands + "delete machine; write_smt2 -wires " + in_scratch("all.smt2"),
            machine.design);

  const auto texts = modules_in(in_scratch("all.smt2"));
  const auto clocks = clocks_in(in_scratch("m0"));
  original_.emplace_back("m0", texts.at("m0"), !machine.seen.empty());
  for (const unsigned k : numbers) {
    const std::string name = fmt::format("m{}", k);
    bool same_clocks = true;
    for (const auto& [cell, edge] : clocks_in(in_scratch(name))) {
      const auto in_original = clocks.find(cell);
      same_clocks = same_clocks && edge != Edge::other && in_original != clocks.end() &&
                    in_original->second == edge;
    }
    mutants_.push_back({k, Rtl(name, texts.at(name), !machine.seen.empty()), same_clocks});
  }
}

Claim Mutants::base_case(std::size_t i) const {
  const Mutant& mutant = mutants_[i];
  Script script = declared(machine_);
  Side side("mutant", machine_, mutant.rtl, {}, script);
  for (const Wire& w : machine_.reset_inputs) {
    script.assume(equal(symbol("in", w.field), w.code));
  }
  Expression wrong = truth(false);
  const std::vector<Expression> after = side.after(machine_);
  for (std::size_t w = 0; w < after.size(); ++w) {
    const Wire& reset = machine_.reset_state[w];
    if (reset.field.unreset) continue;  // whatever it holds, the model takes it over
    wrong = disjunction(wrong, where_compared(reset, differ(after[w], reset.code)));
  }
  return asked("base case: a reset makes them the same", fmt::format("mutant {}", mutant.number),
               script, wrong);
}

Claim Mutants::step(std::size_t i) const {
  const Mutant& mutant = mutants_[i];
  Script script = declared(machine_);
  for (const auto* all : {&machine_.invariant, &machine_.reached, &machine_.legal}) {
    for (const Named& n : *all) script.assume(n.condition);
  }
  Side before("original", machine_, original_.front(), machine_.registers, script);
  Side with("mutant", machine_, mutant.rtl, machine_.registers, script);
  std::vector<std::string> terms;
  for (const auto* wires : {&machine_.inputs, &machine_.state}) {
    for (const Wire& w : *wires) terms.push_back(w.code.text());
  }
  Expression wrong = truth(false);
  const auto all_differ = [&](const char* what, const std::vector<Wire>& wires,
                              const std::vector<Expression>& a, const std::vector<Expression>& b) {
    const auto named = [&](const char* side, const Wire& w, const Expression& code) {
      terms.push_back(term_of(side, w.field) + what);
      return script.define(terms.back(), code);
    };
    for (std::size_t k = 0; k < a.size(); ++k) {
      const Wire& w = wires[k];
      wrong = disjunction(
          wrong, where_compared(w, differ(named("model", w, a[k]), named("rtl", w, b[k]))));
    }
  };
  all_differ(kAfter, machine_.after, before.after(machine_), with.after(machine_));
  all_differ(kOutput, machine_.outputs, before.outputs(machine_), with.outputs(machine_));
  Claim claim = asked("inductive step: every clock keeps them the same",
                      fmt::format("mutant {}", mutant.number), script, wrong);
  claim.terms = std::move(terms);
  return claim;
}

}  // namespace cosim::proof
