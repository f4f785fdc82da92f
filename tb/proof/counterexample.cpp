#include "tb/proof/counterexample.h"

#include "tb/proof/terms.h"

namespace cosim::proof {

std::optional<Counterexample> counterexample(const MachineFormula& m,
                                             const std::map<std::string, std::string>& values) {
  bool whole = true;
  const auto word = [&](const std::string& term) {
    const auto found = values.find(term);
    if (found == values.end()) {
      whole = false;
      return Word{0};
    }
    const std::string& text = found->second;
    if (text == "true" || text == "false") return Word{text == "true"};
    const int base = text[1] == 'x' ? 16 : 2;
    return static_cast<Word>(std::stoull(text.substr(2), nullptr, base));
  };
  Counterexample c;
  for (const Wire& w : m.state) {
    const Word code = word(w.code.text());
    const Word value = is_signed(w.field) ? from_twos_complement(code, w.field.width) : code;
    c.state.push_back({w.field, value, value});
  }
  for (const Wire& w : m.inputs) {
    const Word code = word(w.code.text());
    c.inputs.push_back({w.field, code, code});
  }
  const auto pair = [&](const Field& f, const char* what) {
    return Value{f, word(term_of("model", f) + what), word(term_of("rtl", f) + what)};
  };
  for (const Wire& w : m.outputs) c.outputs.push_back(pair(w.field, kOutput));
  for (const Wire& w : m.after) c.after.push_back(pair(w.field, kAfter));
  for (std::size_t i = 0; i < m.invariant_after.size(); ++i) {
    const auto kept = values.find(term_of_invariant(i));
    if (kept != values.end() && kept->second == "false") {
      c.broken.push_back(m.invariant_after[i].name);
    }
  }
  if (!whole) return std::nullopt;
  return c;
}

}  // namespace cosim::proof
