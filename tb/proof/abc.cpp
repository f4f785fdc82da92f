#include "tb/proof/abc.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "tb/support/output_file.h"
#include "tb/support/pattern.h"
#include "tb/support/process.h"
#include "tb/support/read_file.h"

namespace cosim::proof {
namespace {

constexpr int kNoProgram = 127;

// What the gates give where the inputs named in a file of abc are 1 and all others 0.
std::vector<std::uint64_t> run_of(const NetQuestions& questions, const std::string& file) {
  std::set<std::string> set;
  std::error_code error;
  if (std::filesystem::exists(file, error)) {
    static const Pattern given(R"((\S+)@0=1)");
    for (const Pattern::Parts& part : given.all(read_file(file))) set.insert(part[1]);
  }
  std::vector<std::uint64_t> inputs;
  for (const nets::Port& p : questions.inputs) inputs.push_back(set.contains(p.name) ? 1 : 0);
  return nets::run(questions.graph, inputs);
}

bool holds(const std::vector<std::uint64_t>& gates, nets::Bit bit) {
  return (nets::in_runs(gates, bit) & 1) != 0;
}

std::map<std::string, std::string> values_where(const NetQuestions& questions,
                                                const std::vector<std::uint64_t>& gates) {
  std::map<std::string, std::string> values;
  for (const auto& [term, code] : questions.terms) {
    std::string text;
    for (const nets::Bit bit : code) text += holds(gates, bit) ? '1' : '0';
    std::reverse(text.begin(), text.end());
    values[term] = "#b" + text;
  }
  return values;
}

}  // namespace

std::vector<std::string> netlists(const NetQuestions& questions) {
  std::vector<std::string> all;
  for (const nets::Port& p : questions.asked) {
    all.push_back(nets::to_blif("question", questions.graph, questions.inputs, {{"asked", p.bit}}));
  }
  return all;
}

Solved solve(const NetQuestions& questions, int limit, const std::atomic<bool>* no_more) {
  const Scratch scratch;
  const auto in_scratch = [&](const char* name, std::size_t i) {
    return (scratch.path() / fmt::format("{}{}", name, i)).string();
  };
  // Equal gates are found first (SAT sweeping), then a SAT solver has the rest. With no more than
  // the 100 conflicts for each pair of gates that abc allows by itself, wide shapes took twice as
  // long. On all shapes together neither `iprove` nor `&fraig` was faster.
  std::string commands;
  const auto texts = netlists(questions);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    OutputFile file(in_scratch("asked", i));
    file.text(texts[i]);
    file.close();
    commands += fmt::format("read_blif {}; strash; ifraig -C 2000; dsat; write_cex -n {}; ",
                            in_scratch("asked", i), in_scratch("found", i));
  }
  const Ended ended = run_program({"yosys-abc", "-s", "-q", commands}, limit, no_more);

  Solved solved;
  solved.seconds = ended.seconds;
  std::istringstream lines(ended.text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("UNSATISFIABLE")) {
      solved.answers.push_back(Answer::unsat);
    } else if (line.starts_with("SATISFIABLE")) {
      const std::size_t i = solved.answers.size();
      const auto gates = run_of(questions, in_scratch("found", i));
      if (i >= texts.size() || !holds(gates, questions.asked[i].bit)) {
        solved.said = "what it found is no answer";
        break;
      }
      solved.answers.push_back(Answer::sat);
      if (solved.values.empty()) solved.values = values_where(questions, gates);
    } else if (line.starts_with("UNDECIDED")) {
      solved.answers.push_back(Answer::unknown);
    } else if (solved.said.empty() && !line.starts_with("Counter-example is not")) {
      solved.said = line;
    }
  }
  if (ended.timed_out) {
    const bool is_stopped = no_more != nullptr && *no_more;
    solved.answer = is_stopped ? Answer::stopped : Answer::timed_out;
  } else if (ended.status == kNoProgram) {
    solved.answer = Answer::missing;
  } else if (ended.status == 0 && solved.answers.size() == texts.size()) {
    solved.answer = solved.answers.front();
  }
  if (solved.answer == Answer::failed) solved.answers.clear();
  return solved;
}

}  // namespace cosim::proof
