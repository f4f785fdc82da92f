// The engine that is quick on nets goes first, and what it refutes is decided: a mutant that can be
// told apart is only not counted as equal. "The same" needs two engines; so only what the first
// could not refute is given to the others, one after the other until enough agree.
#include "tb/proof/judge.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "model/core/input_error.h"
#include "tb/proof/abc.h"
#include "tb/proof/counterexample.h"
#include "tb/proof/mutant_nets.h"
#include "tb/proof/mutants.h"
#include "tb/proof/votes.h"
#include "tb/support/parallel.h"

namespace cosim::proof {
namespace {

namespace fs = std::filesystem;

Judged judged_by_abc(Answer answer) {
  if (answer == Answer::unsat) return {true, false, false, "proved"};
  const bool is_other = answer == Answer::sat;
  return {false, is_other, answer == Answer::timed_out,
          (is_other ? "REFUTED: cec " : "UNDECIDED: cec ") + to_text(answer)};
}

}  // namespace

Judge::Judge(const MachineFormula& machine, const nets::Model* model, std::string top,
             Asking asking)
    : machine_(machine), model_(model), top_(std::move(top)), asking_(std::move(asking)) {
  // Under an asynchronous reset the nets of registers are more than flip-flops.
  if (!machine_.seen.empty()) model_ = nullptr;
  if (model_ == nullptr) std::erase(asking_.engines, Engine::cec);
  if (asking_.engines.empty()) throw InputError(machine.design + ": needs another engine than cec");
}

void Judge::ask_reached() {
  std::call_once(once_, [&] {
    const Claim reached = reached_claim(machine_, model_);
    const Decision stays = decide({&reached}, asking_).front();
    for (const Opinion& o : stays.opinions) {
      if (o.solved.front().answer == Answer::missing) {
        throw InputError("needs " + to_text(o.engine));
      }
    }
    if (!stays.proved) not_reached_ = reached.what + ": " + stays.verdict;
  });
}

// One of each mutant.
std::vector<std::vector<Opinion>> Judge::opinions_of_abc(
    const fs::path& verilog, const std::vector<unsigned>& numbers) const {
  const Source source = read_for(machine_, {{fs::absolute(verilog)}, top_, {}});
  const MutantNets nets = nets_of_mutants(*model_, RtlNets(source), numbers);
  Solved solved;
  if (!nets.questions.asked.empty()) {
    solved = solve(nets.questions,
                   asking_.limit * static_cast<int>(std::min<std::size_t>(numbers.size(), 10)));
  }
  std::vector<std::vector<Opinion>> all;
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
    all.push_back({Opinion{Engine::cec, {one}}});
  }
  return all;
}

std::vector<Judged> Judge::judge(const fs::path& verilog, const std::vector<unsigned>& numbers) {
  ask_reached();
  if (!not_reached_.empty()) {
    return std::vector(numbers.size(), Judged{false, false, false, "UNDECIDED: " + not_reached_});
  }
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
    const std::vector<unsigned> open(numbers.begin() + static_cast<std::ptrdiff_t>(first),
                                     numbers.begin() + static_cast<std::ptrdiff_t>(last));
    // What is left to the other engines, and what they are to know of it.
    std::vector<std::size_t> places;
    std::vector<unsigned> left;
    std::vector<std::vector<Opinion>> already(open.size());
    if (asks_abc) already = opinions_of_abc(verilog, open);
    for (std::size_t i = 0; i < open.size(); ++i) {
      const Answer answer = asks_abc ? already[i].front().solved.front().answer : Answer::unknown;
      if (asks_abc && (answer == Answer::sat || others.empty())) {
        all[first + i] = judged_by_abc(answer);
      } else {
        places.push_back(i);
        left.push_back(open[i]);
      }
    }
    if (left.empty()) return true;
    const Mutants mutants(machine_, verilog, left);
    for (std::size_t i = 0; i < mutants.size(); ++i) {
      all[first + places[i]] =
          mutants.has_same_clocks(i)
              ? judged_by(mutants.step(i), mutants.base_case(i), already[places[i]], others, needed)
              : Judged{false, true, false, "REFUTED: a register with another clock"};
    }
    return true;
  });
  return all;
}

std::string Judge::told_apart(const fs::path& verilog, unsigned number) const {
  const Claim step = Mutants(machine_, verilog, {number}).step(0);
  for (const Engine engine : asking_.engines) {
    if (engine == Engine::cec) continue;
    const auto found = counterexample(
        machine_,
        values(solver_of(engine), step.queries.front().script, step.terms, asking_.limit));
    if (found) return to_text(*found);
  }
  return "";
}

// By the engines that read scripts, one after the other until enough agree. An engine's answers to
// both claims are one opinion.
Judged Judge::judged_by(const Claim& step, const Claim& base_case, std::vector<Opinion> opinions,
                        const std::vector<Engine>& engines, std::size_t needed) const {
  const auto yes = [&] {
    return std::count_if(opinions.begin(), opinions.end(),
                         [](const Opinion& o) { return o.solved.front().answer == Answer::unsat; });
  };
  for (const Engine engine : engines) {
    if (static_cast<std::size_t>(yes()) >= needed) break;
    Opinion own{engine, {}};
    for (const Claim* claim : {&step, &base_case}) {
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
