#include "tb/proof/engines.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <set>
#include <sstream>

#include "model/core/input_error.h"
#include "tb/nets/runs.h"
#include "tb/proof/sat.h"
#include "tb/util/interrupt.h"
#include "tb/util/output_file.h"
#include "tb/util/pattern.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::proof {

std::vector<std::string> as_aiger(const Questions& questions) {
  std::map<std::size_t, std::string> names;
  for (const nets::Port& p : questions.inputs) names[p.bit.gate()] = p.name;
  std::vector<std::string> all;
  for (const nets::Port& asked : questions.asked) {
    all.push_back(aiger(questions.graph, {asked.bit}, names));
  }
  return all;
}

namespace {

// What the terms are in run 0 of `gates` (nets::run).
std::map<std::string, Word> values_in(const Questions& questions,
                                      const std::vector<std::uint64_t>& gates) {
  std::map<std::string, Word> values;
  for (const auto& [term, code] : questions.terms) {
    Word& value = values[term];
    for (std::size_t i = 0; i < code.size(); ++i) {
      value |= static_cast<Word>(nets::in_runs(gates, code[i]) & 1) << i;
    }
  }
  return values;
}

// Tries what an engine found: the inputs, a number each, 0 or 1. Where `asked` is not 1 then, the
// engine has failed, and the answers go; else the values of the terms are those of the first time.
bool take(const Questions& questions, nets::Bit asked, const std::vector<std::uint64_t>& inputs,
          Solved& solved) {
  const auto gates = nets::run(questions.graph, inputs);
  if ((nets::in_runs(gates, asked) & 1) == 0) {
    solved.answer = Answer::failed;
    solved.answers.clear();
    solved.said = "what it found is no answer";
    return false;
  }
  if (solved.values.empty()) solved.values = values_in(questions, gates);
  return true;
}

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
  } else if (ended.status == 127) {
    solved.answer = Answer::missing;
  } else if (ended.status == 0 && solved.answers.size() == texts.size()) {
    solved.answer = solved.answers.front();
  }
  if (solved.answer == Answer::failed) solved.answers.clear();
  return solved;
}

double seconds_of_this_thread() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// One solver has the gates once, and is asked for one bit after the other.
Solved solve_by_cadical(const Questions& questions, int limit, const std::atomic<bool>* no_more) {
  const double began = seconds_of_this_thread();
  const auto is_stopped = [&] {
    return (no_more != nullptr && *no_more) || InterruptGuard::signal() != 0;
  };
  Sat sat([&] { return is_stopped() || seconds_of_this_thread() - began > limit; });
  nets::Bits roots;
  for (const nets::Port& asked : questions.asked) roots.push_back(asked.bit);
  Clauses clauses(questions.graph, roots, sat);
  Solved solved;
  for (const nets::Port& asked : questions.asked) {
    const Answer answer =
        asked.bit == nets::no ? Answer::unsat : sat.solve({clauses.of(asked.bit)});
    if (answer == Answer::timed_out) {
      solved.answer = is_stopped() ? Answer::stopped : Answer::timed_out;
      break;
    }
    solved.answers.push_back(answer);
    if (answer == Answer::unsat) continue;
    const std::vector<bool> is = clauses.inputs();
    if (!take(questions, asked.bit, {is.begin(), is.end()}, solved)) break;
  }
  if (solved.answers.size() == questions.asked.size()) solved.answer = solved.answers.front();
  solved.seconds = seconds_of_this_thread() - began;
  InterruptGuard::check();
  return solved;
}

}  // namespace

std::string to_text(Answer answer) {
  switch (answer) {
    case Answer::sat:
      return "sat";
    case Answer::unsat:
      return "unsat";
    case Answer::unknown:
      return "unknown";
    case Answer::timed_out:
      return "timed out";
    case Answer::missing:
      return "missing";
    case Answer::stopped:
      return "stopped";
    case Answer::failed:
      return "failed";
  }
  return "failed";
}

std::string to_text(Engine engine) { return engine == Engine::cec ? "cec" : "cadical"; }

std::vector<Engine> all_engines() { return {Engine::cec, Engine::cadical}; }

std::string listed(const std::vector<Engine>& engines) {
  std::string text;
  for (std::size_t i = 0; i < engines.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == engines.size() ? " and " : ", ") + to_text(engines[i]);
  }
  return text;
}

std::vector<Engine> engines_of(const std::string& list) {
  const std::vector<Engine> all = all_engines();
  std::vector<Engine> chosen;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](Engine e) { return to_text(e) == word; });
    if (found == all.end() || std::count(chosen.begin(), chosen.end(), *found) != 0) {
      throw InputError(
          fmt::format("--engines {}: takes {}, each once", in_quotes(list), listed(all)));
    }
    chosen.push_back(*found);
  }
  if (chosen.empty()) throw InputError("--engines: needs one");
  return chosen;
}

Solved solve(Engine engine, const Questions& questions, int limit,
             const std::atomic<bool>* no_more) {
  return engine == Engine::cec ? solve_by_abc(questions, limit, no_more)
                               : solve_by_cadical(questions, limit, no_more);
}

}  // namespace cosim::proof
