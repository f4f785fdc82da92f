#include "tb/proof/mutants.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "model/core/input_error.h"
#include "tb/proof/abc.h"
#include "tb/proof/located.h"
#include "tb/proof/mutant_nets.h"
#include "tb/support/parallel.h"
#include "tb/support/place.h"
#include "tb/support/process.h"
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
       {&m.invariant_after, &m.reached_after, &m.invariant_cleared, &m.reached_cleared}) {
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
  for (const Wire& w : machine.registers) {
    if (w.field.index <= 0) kept += kept_net(net_path(w.field.net).path);
  }
  // Before prep for registers that nothing reads, after it for those it makes of memories.
  std::string commands = fmt::format(
      "read_verilog \"{0}\"; setattr -set keep 1 {2}; prep -flatten -nomem -top {1}; "
      "memory_collect; memory_map; rename -top machine; setattr -set keep 1 {2}; "
      "async2sync; dffunmap; setundef -anyseq; ",
      fs::absolute(verilog).string(), machine.design, kept);
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

Claim Mutants::clear(std::size_t i) const {
  const Mutant& mutant = mutants_[i];
  Script script = declared(machine_);
  Side side("mutant", machine_, mutant.rtl, {}, script);
  for (const Wire& w : machine_.clearing) {
    script.assume(equal(symbol("in", w.field), w.code));
  }
  Expression wrong = truth(false);
  const std::vector<Expression> after = side.after(machine_);
  for (std::size_t w = 0; w < after.size(); ++w) {
    const Wire& cleared = machine_.cleared[w];
    if (cleared.field.unreset) continue;  // whatever it holds, the model takes it over
    wrong = disjunction(wrong, where_compared(cleared, differ(after[w], cleared.code)));
  }
  return asked("a clear makes them the same", fmt::format("mutant {}", mutant.number), script,
               wrong);
}

Claim Mutants::step(std::size_t i) const {
  const Mutant& mutant = mutants_[i];
  Script script = declared(machine_);
  for (const auto* all : {&machine_.invariant, &machine_.reached, &machine_.legal}) {
    for (const Named& n : *all) script.assume(n.condition);
  }
  Side before("original", machine_, original_.front(), machine_.registers, script);
  Side with("mutant", machine_, mutant.rtl, machine_.registers, script);
  Expression wrong = truth(false);
  const auto all_differ = [&](const std::vector<Wire>& wires, const std::vector<Expression>& a,
                              const std::vector<Expression>& b) {
    for (std::size_t w = 0; w < a.size(); ++w) {
      wrong = disjunction(wrong, where_compared(wires[w], differ(a[w], b[w])));
    }
  };
  all_differ(machine_.after, before.after(machine_), with.after(machine_));
  all_differ(machine_.outputs, before.outputs(machine_), with.outputs(machine_));
  return asked("every clock keeps them the same", fmt::format("mutant {}", mutant.number), script,
               wrong);
}

Judge::Judge(const MachineFormula& machine, const nets::Model* model, Asking asking)
    : machine_(machine), model_(model), asking_(std::move(asking)) {
  // Under an asynchronous reset the nets of registers are more than flip-flops.
  if (!machine_.seen.empty()) model_ = nullptr;
  if (model_ == nullptr) std::erase(asking_.engines, Engine::cec);
  if (asking_.engines.empty()) throw InputError(machine.design + ": needs another engine than cec");
}

void Judge::require_reached() {
  std::call_once(once_, [&] {
    const Claim reached = reached_claim(machine_, model_);
    const Decision stays = decide({&reached}, asking_).front();
    for (const Opinion& o : stays.opinions) {
      if (o.solved.front().answer == Answer::missing) {
        throw InputError("needs " + to_text(o.engine));
      }
    }
    if (!stays.proved) {
      throw InputError(fmt::format("{}: {}: {}", machine_.design, reached.what, stays.verdict));
    }
  });
}

// One of each mutant.
std::vector<Opinion> Judge::opinions_of_abc(const fs::path& verilog,
                                            const std::vector<unsigned>& numbers) const {
  Source source{{fs::absolute(verilog)}, machine_.design, {}};
  for (const Wire& w : machine_.registers) {
    // In the flat module its name has a path in front.
    const std::string path = net_path(w.field.net).path;
    if (w.field.index <= 0) source.kept.push_back("*" + path.substr(path.rfind('.') + 1));
  }
  const MutantNets nets = nets_of_mutants(*model_, RtlNets(source), numbers);
  Solved solved;
  if (!nets.questions.asked.empty()) {
    solved = solve(nets.questions,
                   asking_.limit * static_cast<int>(std::min<std::size_t>(numbers.size(), 10)));
  }
  std::vector<Opinion> all;
  std::size_t asked = 0;
  for (const MutantNets::Known known : nets.known) {
    Solved one;
    if (known != MutantNets::Known::asked) {
      one.answer = known == MutantNets::Known::same ? Answer::unsat : Answer::sat;
      one.answers = {one.answer};
    } else if (asked < solved.answers.size()) {
      one.answer = solved.answers[asked++];
      one.answers = {one.answer};
    } else {
      one.answer = solved.answer == Answer::unsat || solved.answer == Answer::sat ? Answer::failed
                                                                                  : solved.answer;
      one.said = solved.said;
    }
    all.push_back({Engine::cec, {one}});
  }
  return all;
}

std::vector<Judged> Judge::judge(const fs::path& verilog, const std::vector<unsigned>& numbers) {
  require_reached();
  const bool asks_abc =
      std::count(asking_.engines.begin(), asking_.engines.end(), Engine::cec) != 0;
  std::vector<Engine> others = asking_.engines;
  std::erase(others, Engine::cec);
  const std::size_t needed = std::min<std::size_t>(asking_.engines.size(), 2);

  // Each run of yosys reads the file anew.
  constexpr std::size_t a_run = 64;
  std::vector<Judged> all(numbers.size());
  in_parallel((numbers.size() + a_run - 1) / a_run, asking_.jobs, [&](std::uint64_t run) {
    const std::size_t first = run * a_run, last = std::min(first + a_run, numbers.size());
    std::vector<unsigned> open(numbers.begin() + static_cast<std::ptrdiff_t>(first),
                               numbers.begin() + static_cast<std::ptrdiff_t>(last));
    std::vector<std::size_t> place;
    std::vector<Opinion> of_abc(open.size());
    if (asks_abc) of_abc = opinions_of_abc(verilog, open);
    std::vector<unsigned> left;
    std::vector<Opinion> already;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const Answer answer = asks_abc ? of_abc[i].solved.front().answer : Answer::unknown;
      if (asks_abc && (answer == Answer::sat || others.empty())) {
        all[first + i] = {answer == Answer::unsat, answer == Answer::sat,
                          answer == Answer::timed_out,
                          answer == Answer::unsat ? "proved" : "REFUTED: cec " + to_text(answer)};
        if (answer != Answer::sat && answer != Answer::unsat) {
          all[first + i].verdict = "UNDECIDED: cec " + to_text(answer);
        }
        continue;
      }
      left.push_back(open[i]);
      place.push_back(first + i);
      already.push_back(of_abc[i]);
    }
    if (left.empty()) return true;
    const Mutants mutants(machine_, verilog, left);
    for (std::size_t i = 0; i < mutants.size(); ++i) {
      Judged& judged = all[place[i]];
      if (!mutants.has_same_clocks(i)) {
        judged = {false, true, false, "REFUTED: a register with another clock"};
        continue;
      }
      judged =
          judged_by(mutants.step(i), mutants.clear(i),
                    asks_abc ? std::vector{already[i]} : std::vector<Opinion>{}, others, needed);
    }
    return true;
  });
  return all;
}

// By the engines that read scripts, one after the other until enough agree. An engine's answers to
// both claims are one opinion.
Judged Judge::judged_by(const Claim& step, const Claim& clear, std::vector<Opinion> opinions,
                        const std::vector<Engine>& engines, std::size_t needed) const {
  const auto yes = [&] {
    return std::count_if(opinions.begin(), opinions.end(),
                         [](const Opinion& o) { return o.solved.front().answer == Answer::unsat; });
  };
  for (const Engine engine : engines) {
    if (static_cast<std::size_t>(yes()) >= needed) break;
    Opinion own{engine, {}};
    for (const Claim* claim : {&step, &clear}) {
      const Decision d = decide({claim}, {{engine}, asking_.limit, 1}).front();
      own.solved = d.opinions.front().solved;
      if (own.solved.front().answer != Answer::unsat) break;
    }
    opinions.push_back(std::move(own));
    if (opinions.back().solved.front().answer == Answer::sat) break;
  }
  Claim claim = step;
  if (!opinions.empty() && opinions.front().engine == Engine::cec) {
    NetQuestions nets;
    nets.asked.push_back({claim.queries.front().asks.front(), nets::no});  // by which it goes
    claim.nets = std::make_shared<const NetQuestions>(std::move(nets));
  }
  const Decision d = judged(claim, std::move(opinions), needed);
  return {d.proved, d.refuted, timed_out({d}), d.verdict};
}

}  // namespace cosim::proof
