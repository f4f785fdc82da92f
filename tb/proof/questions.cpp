#include "tb/proof/questions.h"

#include "tb/nets/runs.h"

namespace cosim::proof {

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

std::vector<std::string> as_aiger(const Questions& questions) {
  std::map<std::size_t, std::string> names;
  for (const nets::Port& p : questions.inputs) names[p.bit.gate()] = p.name;
  std::vector<std::string> all;
  for (const nets::Port& asked : questions.asked) {
    all.push_back(aiger(questions.graph, asked.bit, names));
  }
  return all;
}

}  // namespace cosim::proof
