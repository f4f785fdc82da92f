#include "tb/proof/explain.h"

#include <fmt/core.h>

#include "tb/support/show.h"

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

std::vector<Word> words(const std::vector<Value>& values) {
  std::vector<Word> all;
  for (const Value& v : values) all.push_back(v.expected);
  return all;
}

}  // namespace

Stimulus stimulus_of(const Counterexample& c, const AnyBench& bench) {
  Stimulus s;
  s.machine = bench.title();
  s.origin = "counterexample of the proof";
  s.state = words(c.state);
  s.clocks = {words(c.inputs), bench.idle_after(*s.state, words(c.inputs))};
  return s;
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
