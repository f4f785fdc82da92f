#include "tb/proof/theorems.h"

#include <fmt/core.h>

#include <iterator>

#include "model/core/input_error.h"
#include "tb/proof/engines.h"
#include "tb/proof/machines.h"
#include "tb/util/output_file.h"
#include "tb/util/process.h"
#include "tb/util/scratch.h"

namespace cosim::proof {
namespace {

// What z3 says of a script of one question.
Solved solve_by_z3(const std::string& script, int limit) {
  constexpr int no_program = 127;
  const Scratch scratch;
  const std::string name = (scratch.path() / "script.smt2").string();
  OutputFile file(name);
  file.text(script);
  file.close();
  const Ended ended = run_program({"z3", "-smt2", name}, limit);
  if (ended.status == no_program) throw InputError("needs z3");
  Solved solved;
  solved.seconds = ended.seconds;
  solved.said = ended.text.substr(0, ended.text.find('\n'));
  for (const Answer one : {Answer::sat, Answer::unsat, Answer::unknown}) {
    if (ended.status == 0 && ended.text == to_text(one) + '\n') solved.answer = one;
  }
  if (ended.timed_out) solved.answer = Answer::timed_out;
  return solved;
}

// Takes over that an answer is not the one wanted.
void take(Judgement& all, Answer answer, Answer wanted, const std::string& what,
          const std::string& said) {
  if (!all.proved || answer == wanted) return;
  all.proved = false;
  all.timed_out = answer == Answer::timed_out;
  const bool is_opposite = answer == Answer::sat || answer == Answer::unsat;
  const char* otherwise = wanted == Answer::unsat ? "REFUTED" : "its premises cannot be";
  all.verdict = is_opposite ? fmt::format("{} ({})", otherwise, what)
                            : fmt::format("UNDECIDED: {} ({}){}", to_text(answer), what,
                                          answer == Answer::failed ? ": " + said : "");
}

}  // namespace

std::vector<Theorem> joined(std::vector<std::vector<Theorem>> lists) {
  std::vector<Theorem> all;
  for (auto& list : lists) std::move(list.begin(), list.end(), std::back_inserter(all));
  return all;
}

Judgement judged(const Theorem& theorem, int limit) {
  if (!theorem.on_integers && theorem.on_bits.empty()) {
    return {false, false, "UNDECIDED: nothing is asked, for no width of the design is built", 0};
  }
  Judgement all{true, false, "proved", 0};
  const auto ask_z3 = [&](const std::string& script, Answer wanted) {
    const Solved solved = solve_by_z3(script, limit);
    all.seconds += solved.seconds;
    take(all, solved.answer, wanted, "any", solved.said);
  };
  if (theorem.on_integers) ask_z3(theorem.on_integers->negated, Answer::unsat);
  if (theorem.on_integers && all.proved) ask_z3(theorem.on_integers->premises, Answer::sat);
  for (const OnBits& one : theorem.on_bits) {
    if (!all.proved) return all;
    const Solved solved = solve(Engine::cadical, one.questions, limit);
    all.seconds += solved.seconds;
    const auto answer = [&](std::size_t i) {
      return i < solved.answers.size() ? solved.answers[i] : solved.answer;
    };
    take(all, answer(0), Answer::unsat, one.what, solved.said);
    take(all, answer(1), Answer::sat, one.what, solved.said);
  }
  return all;
}

nets::Bits FreeNumbers::code(const std::string& name, int width) {
  nets::Bits bits;
  for (int i = 0; i < width; ++i) {
    bits.push_back(graph_.input());
    inputs_.push_back({fmt::format("{}[{}]", name, i), bits.back()});
  }
  return bits;
}
nets::Number FreeNumbers::number(const std::string& name, int width) {
  return nets::Number::unsigned_code(graph_, code(name, width));
}
nets::Number FreeNumbers::signed_number(const std::string& name, int width) {
  return nets::Number::signed_code(graph_, code(name, width));
}

OnBits FreeNumbers::asked(const std::string& what, const nets::Truth& wrong) {
  const nets::Bit negated = (assumed_ & wrong).bit();
  return {what, {graph_, inputs_, {{what, negated}, {what + ", premises", assumed_.bit()}}, {}}};
}

Theorem at_every_width(const std::string& design, const std::string& sentence,
                       nets::Truth (*wrong)(const Widths&, FreeNumbers&)) {
  Theorem theorem{design, sentence};
  for (const auto& machine : built_machines()) {
    if (!machine.title.starts_with(design + ' ')) continue;
    FreeNumbers free;
    const nets::Truth not_so = wrong(machine.nets().machine.parameters, free);
    theorem.on_bits.push_back(free.asked(machine.title, not_so));
  }
  return theorem;
}

}  // namespace cosim::proof
