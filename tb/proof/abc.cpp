// Questions put to yosys-abc.
#include <fmt/core.h>

#include <filesystem>
#include <set>
#include <sstream>

#include "tb/proof/engines_detail.h"
#include "tb/support/output_file.h"
#include "tb/support/pattern.h"
#include "tb/support/process.h"
#include "tb/support/read_file.h"

namespace cosim::proof {
namespace {

constexpr int kNoProgram = 127;

// Which inputs are 1, by a file of abc that names those.
std::vector<std::uint64_t> inputs_in(const Questions& questions, const std::string& file) {
  std::set<std::string> set;
  std::error_code error;
  if (std::filesystem::exists(file, error)) {
    static const Pattern given(R"((\S+)@0=1)");
    for (const Pattern::Parts& part : given.all(read_file(file))) set.insert(part[1]);
  }
  std::vector<std::uint64_t> inputs;
  for (const nets::Port& p : questions.inputs) inputs.push_back(set.contains(p.name) ? 1 : 0);
  return inputs;
}

}  // namespace

Solved solve_by_abc(const Questions& questions, int limit, const std::atomic<bool>* no_more) {
  const Scratch scratch;
  const auto in_scratch = [&](const char* name, std::size_t i) {
    return (scratch.path() / fmt::format("{}{}", name, i)).string();
  };
  // Equal gates are found first (SAT sweeping), then a SAT solver has the rest. With no more than
  // the 100 conflicts for each pair of gates that abc allows by itself, wide shapes took twice as
  // long. On all shapes together neither `iprove` nor `&fraig` was faster.
  std::string commands;
  const auto texts = as_aiger(questions);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    OutputFile file(in_scratch("asked", i));
    file.text(texts[i]);
    file.close();
    commands += fmt::format("read_aiger {}; strash; ifraig -C 2000; dsat; write_cex -n {}; ",
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
      if (i >= texts.size()) break;
      const auto inputs = inputs_in(questions, in_scratch("found", i));
      if (!take(questions, questions.asked[i].bit, inputs, solved)) break;
      solved.answers.push_back(Answer::sat);
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
