#include "tb/proof/counterexample.h"

#include <fmt/core.h>

#include "tb/util/show.h"

namespace cosim::proof {
namespace {

std::string rows(const char* kind, const std::vector<Value>& values) {
  std::string text;
  for (const Value& v : values) {
    text += fmt::format("  {:<6} {:<14} {}", kind, label_of(v.field), show(v.field, v.expected));
    text += v.expected == v.actual ? "\n"
                                   : fmt::format("   expected\n  {:<6} {:<14} {}   actual\n", "",
                                                 "", show(v.field, v.actual));
  }
  return text;
}

}  // namespace

std::string term_of(const char* side, const Field& field) {
  return field.index < 0 ? fmt::format("{}.{}", side, field.name)
                         : fmt::format("{}.{}.{}", side, field.name, field.index);
}

std::string term_of_invariant(std::size_t i) { return fmt::format("model.kept.{}", i); }

std::optional<Counterexample> counterexample(const nets::Model& model,
                                             const std::map<std::string, Word>& values) {
  const auto& m = model.machine;
  bool whole = true;
  const auto word = [&](const std::string& term) {
    const auto found = values.find(term);
    whole = whole && found != values.end();
    return found == values.end() ? Word{0} : found->second;
  };
  Counterexample c;
  for (const nets::Wire& w : m.state) {
    const Word code = word(term_of("state", w.field));
    const Word value = is_signed(w.field) ? from_twos_complement(code, w.field.width) : code;
    c.state.push_back({w.field, value, value});
  }
  for (const nets::Wire& w : m.inputs) {
    const Word code = word(term_of("in", w.field));
    c.inputs.push_back({w.field, code, code});
  }
  const auto pair = [&](const Field& f, const char* what) {
    return Value{f, word(term_of("model", f) + what), word(term_of("rtl", f) + what)};
  };
  for (const nets::Wire& w : m.outputs) c.outputs.push_back(pair(w.field, kOutput));
  for (const nets::Wire& w : m.after) c.after.push_back(pair(w.field, kAfter));
  for (std::size_t i = 0; i < m.invariant_after.size(); ++i) {
    const auto kept = values.find(term_of_invariant(i));
    if (kept != values.end() && kept->second == 0) {
      c.broken.push_back(m.invariant_after[i].name);
    }
  }
  if (!whole) return std::nullopt;
  return c;
}

std::vector<Word> words(const std::vector<Value>& values) {
  std::vector<Word> all;
  for (const Value& v : values) all.push_back(v.expected);
  return all;
}

std::string to_text(const Counterexample& c) {
  std::string text = "from this state, under these inputs:\n";
  std::vector<Value> codes = c.state;
  for (Value& v : codes) {
    v.field.format = is_signed(v.field) ? Format::twos_complement : v.field.format;
    v.field.fraction = 0;  // as a stimulus has it
    v.expected = v.actual = cosim::low_bits(v.expected, v.field.width);
  }
  text += rows("state", codes) + rows("in", c.inputs) + rows("out", c.outputs);
  text += rows("after", c.after);
  for (const std::string& b : c.broken) text += fmt::format("  broken after it: {}\n", b);
  return text;
}

}  // namespace cosim::proof
