#include "tb/proof/judge.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "model/core/input_error.h"
#include "tb/proof/counterexample.h"
#include "tb/proof/mutant_questions.h"
#include "tb/util/parallel.h"

namespace cosim::proof {

namespace fs = std::filesystem;

Judge::Judge(const nets::Model& model, std::string top, Asking asking)
    : model_(model), top_(std::move(top)), asking_(std::move(asking)) {
  // The solver of this program is asked first: it starts at once.
  std::ranges::reverse(asking_.engines);
}

void Judge::ask_reached() {
  std::call_once(once_, [&] {
    const Claim reached = reached_claim(model_);
    const Decision stays = decide({&reached}, asking_).front();
    for (const Opinion& o : stays.opinions) {
      if (o.solved.answer == Answer::missing) throw InputError("needs " + to_text(o.engine));
    }
    if (!stays.proved) not_reached_ = reached.what + ": " + stays.verdict;
  });
}

RtlNets Judge::nets_of(const fs::path& verilog) const {
  return RtlNets(read_for(model_.machine, {{fs::absolute(verilog)}, top_, {}}));
}

std::vector<Judged> Judge::judged(const RtlNets& rtl, const std::vector<unsigned>& numbers) const {
  const MutantQuestions mutants = questions_of_mutants(model_, rtl, numbers);
  std::vector<Judged> all(numbers.size(), Judged{false, false, false, "proved"});
  std::vector<std::size_t> open;  // by bit that is asked
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    using Known = MutantQuestions::Known;
    if (mutants.known[i] == Known::asked) open.push_back(i);
    all[i].same = mutants.known[i] == Known::same;
    all[i].refuted = mutants.known[i] == Known::other;
    if (all[i].refuted) all[i].verdict = "REFUTED: its nets differ";
  }
  Questions left = mutants.questions;
  const int limit = asking_.limit * static_cast<int>(std::min<std::size_t>(numbers.size(), 10));
  for (const Engine engine : asking_.engines) {
    if (open.empty()) break;
    const Solved solved = solve(engine, left, limit);
    std::vector<std::size_t> agreed;
    std::vector<nets::Port> asked;
    for (std::size_t q = 0; q < open.size(); ++q) {
      Judged& mutant = all[open[q]];
      const bool is_answered = q < solved.answers.size();
      const Answer answer = is_answered ? solved.answers[q] : solved.answer;
      if (is_answered && answer == Answer::unsat) {
        agreed.push_back(open[q]);
        asked.push_back(left.asked[q]);
        continue;
      }
      mutant.refuted = is_answered && answer == Answer::sat;
      mutant.timed_out = answer == Answer::timed_out;
      mutant.verdict = fmt::format("{}: {} {}", mutant.refuted ? "REFUTED" : "UNDECIDED",
                                   to_text(engine), to_text(answer));
    }
    open = std::move(agreed);
    left.asked = std::move(asked);
  }
  for (const std::size_t i : open) all[i].same = true;
  return all;
}

std::vector<Judged> Judge::judge(const fs::path& verilog, const std::vector<unsigned>& numbers) {
  ask_reached();
  if (!not_reached_.empty()) {
    return std::vector(numbers.size(), Judged{false, false, false, "UNDECIDED: " + not_reached_});
  }
  const RtlNets rtl = nets_of(verilog);
  constexpr std::size_t a_run = 64;
  std::vector<Judged> all(numbers.size());
  in_parallel((numbers.size() + a_run - 1) / a_run, asking_.jobs, [&](std::uint64_t run) {
    const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(run * a_run);
    const auto last =
        numbers.begin() + static_cast<std::ptrdiff_t>(std::min((run + 1) * a_run, numbers.size()));
    std::ranges::move(judged(rtl, {first, last}),
                      all.begin() + static_cast<std::ptrdiff_t>(run * a_run));
    return true;
  });
  return all;
}

std::string Judge::told_apart(const fs::path& verilog, unsigned number) const {
  const Questions question = question_of_mutant(model_, nets_of(verilog), number);
  for (const Engine engine : asking_.engines) {
    const Solved solved = solve(engine, question, asking_.limit);
    if (const auto found = counterexample(model_, solved.values)) return to_text(*found);
  }
  return "";
}

}  // namespace cosim::proof
