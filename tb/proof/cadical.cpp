// Questions put to CaDiCaL: one solver has the gates once, and is asked for one bit after the
// other.
#include <ctime>
#include <set>

#include "tb/proof/engines_detail.h"
#include "tb/proof/sat.h"
#include "tb/support/interrupt.h"

namespace cosim::proof {
namespace {

using nets::Bit;

double seconds_of_this_thread() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The gates of a graph as clauses, as far as they are asked for. A tree of conjunctions that
// nothing else reads is one conjunction of many.
class Clauses {
 public:
  Clauses(const Questions& questions, Sat& sat)
      : graph_(questions.graph), sat_(sat), reads_(graph_.gates().size()) {
    literals_.resize(graph_.gates().size());
    literals_[0] = -sat.variable();
    sat.clause({-literals_[0]});
    for (const nets::Port& asked : questions.asked) ++reads_[asked.bit.gate()];
    for (const nets::Graph::Made& gate : graph_.gates()) {
      for (const Bit read : {gate.a, gate.b, gate.c}) ++reads_[read.gate()];
    }
  }

  Sat::Literal of(Bit bit) {
    std::vector<std::size_t> stack{bit.gate()};
    while (!stack.empty()) {
      const std::size_t at = stack.back(), open = stack.size();
      const std::vector<Bit> all = literals_[at] == 0 ? read_by(at) : std::vector<Bit>{};
      for (const Bit read : all) {
        if (literals_[read.gate()] == 0) stack.push_back(read.gate());
      }
      if (stack.size() > open) continue;
      stack.pop_back();
      if (literals_[at] == 0) literals_[at] = made(graph_.gates()[at].kind, all);
    }
    return literal(bit);
  }
  Sat::Literal literal(Bit bit) const {
    const Sat::Literal is = literals_[bit.gate()];
    return bit.is_inverted() ? -is : is;
  }
  bool is_made(Bit bit) const { return literals_[bit.gate()] != 0; }

 private:
  std::vector<Bit> read_by(std::size_t number) const {
    const nets::Graph::Made& gate = graph_.gates()[number];
    if (gate.kind == nets::Gate::mux) return {gate.a, gate.b, gate.c};
    if (gate.kind != nets::Gate::and_gate) return {gate.a, gate.b};
    std::vector<Bit> leaves, open{gate.a, gate.b};
    while (!open.empty()) {
      const Bit bit = open.back();
      const nets::Graph::Made& below = graph_.gates()[bit.gate()];
      open.pop_back();
      const bool is_own = !bit.is_inverted() && below.kind == nets::Gate::and_gate &&
                          reads_[bit.gate()] == 1 && literals_[bit.gate()] == 0;
      if (is_own) {
        open.push_back(below.a);
        open.push_back(below.b);
      } else {
        leaves.push_back(bit);
      }
    }
    return leaves;
  }
  Sat::Literal made(nets::Gate kind, const std::vector<Bit>& read) {
    std::vector<Sat::Literal> all;
    for (const Bit bit : read) all.push_back(literal(bit));
    switch (kind) {
      case nets::Gate::and_gate:
        return sat_.and_of(all);
      case nets::Gate::xor_gate:
        return sat_.xor_of(all[0], all[1]);
      case nets::Gate::mux:
        return sat_.choose(all[0], all[1], all[2]);
      default:
        return sat_.variable();
    }
  }

  const nets::Graph& graph_;
  Sat& sat_;
  std::vector<unsigned> reads_;         // how many read a gate
  std::vector<Sat::Literal> literals_;  // by gate; 0 where there is none yet
};

}  // namespace

Solved solve_by_cadical(const Questions& questions, int limit, const std::atomic<bool>* no_more) {
  const double began = seconds_of_this_thread();
  const auto is_stopped = [&] {
    return (no_more != nullptr && *no_more) || InterruptGuard::signal() != 0;
  };
  Sat sat([&] { return is_stopped() || seconds_of_this_thread() - began > limit; });
  Clauses clauses(questions, sat);
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
    std::vector<std::uint64_t> inputs;
    for (const nets::Port& input : questions.inputs) {
      const bool is = clauses.is_made(input.bit) && sat.holds(clauses.literal(input.bit));
      inputs.push_back(is ? 1 : 0);
    }
    if (!take(questions, asked.bit, inputs, solved)) break;
  }
  if (solved.answers.size() == questions.asked.size()) solved.answer = solved.answers.front();
  solved.seconds = seconds_of_this_thread() - began;
  InterruptGuard::check();
  return solved;
}

}  // namespace cosim::proof
