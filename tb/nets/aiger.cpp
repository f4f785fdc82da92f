#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "tb/nets/graph.h"

namespace cosim::nets {
namespace {

using Literal = std::uint32_t;  // of AIGER

// The gates of one file, which are all of two inputs.
class Gates {
 public:
  explicit Gates(Literal last) : last_(last) {}

  Literal both(Literal a, Literal b) {
    last_ += 2;
    append(last_ - std::max(a, b));
    append(std::max(a, b) - std::min(a, b));
    ++count_;
    return last_;
  }
  Literal choice(Literal a, Literal b, Literal c) {
    const Literal then = both(a, b), otherwise = both(a ^ 1U, c);
    return both(then ^ 1U, otherwise ^ 1U) ^ 1U;
  }
  Literal last() const { return last_; }
  std::size_t count() const { return count_; }
  const std::string& text() const { return text_; }

 private:
  // Seven bits a byte, the lowest first.
  void append(Literal delta) {
    for (; delta >= 0x80U; delta >>= 7U) text_ += static_cast<char>((delta & 0x7fU) | 0x80U);
    text_ += static_cast<char>(delta);
  }
  Literal last_;
  std::size_t count_ = 0;
  std::string text_;
};

}  // namespace

std::string aiger(const Graph& graph, const Bits& outputs,
                  const std::map<std::size_t, std::string>& names) {
  const std::vector<Graph::Made>& gates = graph.gates();
  // Numbered as AIGER wants it: inputs, latches, gates.
  std::vector<Literal> number(gates.size(), 0);
  Literal next = 0;
  for (const Bit input : graph.inputs()) number[input.gate()] = next += 2;
  Bits roots = outputs;
  for (const Graph::Latch& latch : graph.latches()) {
    number[latch.now.gate()] = (next += 2) + (latch.first ? 1U : 0U);
    roots.push_back(latch.next);
  }
  const auto of = [&](Bit bit) { return number[bit.gate()] ^ (bit.is_inverted() ? 1U : 0U); };
  const std::vector<bool> is_read = graph.cone(roots);
  Gates made(next);
  for (std::size_t i = 0; i < gates.size(); ++i) {
    if (!is_read[i] || !gates[i].is_logic()) continue;
    const Literal a = of(gates[i].a), b = of(gates[i].b);
    number[i] = gates[i].kind == Gate::and_gate   ? made.both(a, b)
                : gates[i].kind == Gate::xor_gate ? made.choice(a, b ^ 1U, b)
                                                  : made.choice(a, b, of(gates[i].c));
  }
  const auto& inputs = graph.inputs();
  const auto& latches = graph.latches();
  std::string text = fmt::format("aig {} {} {} {} {}\n", made.last() / 2, inputs.size(),
                                 latches.size(), outputs.size(), made.count());
  for (const Graph::Latch& latch : latches) {
    text += fmt::format("{}\n", of(latch.next) ^ (latch.first ? 1U : 0U));
  }
  for (const Bit output : outputs) text += fmt::format("{}\n", of(output));
  text += made.text();
  const auto name = [&](char kind, char otherwise, std::size_t i, Bit bit) {
    const auto given = names.find(bit.gate());
    text += fmt::format("{}{} {}\n", kind, i,
                        given == names.end() ? fmt::format("{}{}", otherwise, i) : given->second);
  };
  for (std::size_t i = 0; i < inputs.size(); ++i) name('i', 'p', i, inputs[i]);
  for (std::size_t i = 0; i < latches.size(); ++i) name('l', 'r', i, latches[i].now);
  return text;
}

}  // namespace cosim::nets
