#include "tb/equiv/equiv.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "model/core/input_error.h"
#include "tb/equiv/product.h"
#include "tb/proof/reach.h"

namespace cosim::equiv {
namespace {

using Widths = std::map<std::string, int>;

std::string gate_name(const Question& q, const std::string& port) {
  const auto at = q.renamed.find(port);
  return at == q.renamed.end() ? port : at->second;
}

// Ports of one side that the other lacks, or has in another width.
void find_lacking(const Question& q, const Widths& gold, const Widths& gate, bool inputs,
                  std::vector<std::string>& lacking) {
  const auto is_free = [&](const std::string& port) {
    if (inputs && (port == q.gold.clock || port == q.gate.clock)) return true;
    return inputs ? q.tied.contains(port)
                  : std::find(q.ignored.begin(), q.ignored.end(), port) != q.ignored.end();
  };
  std::set<std::string> met;
  for (const auto& [port, width] : gold) {
    const std::string other = gate_name(q, port);
    met.insert(other);
    if (is_free(port)) continue;
    const auto at = gate.find(other);
    if (at == gate.end()) {
      lacking.push_back(port + " only in the old");
    } else if (at->second != width) {
      lacking.push_back(fmt::format("{} has {} bits and {}", port, width, at->second));
    }
  }
  for (const auto& [port, width] : gate) {
    if (!met.contains(port) && !is_free(port)) lacking.push_back(port + " only in the new");
  }
}

void require_ports(const Question& q) {
  std::vector<std::string> lacking;
  find_lacking(q, q.gold.inputs, q.gate.inputs, true, lacking);
  find_lacking(q, q.gold.outputs, q.gate.outputs, false, lacking);
  if (!lacking.empty()) {
    std::string list;
    for (const std::string& one : lacking) list += (list.empty() ? "" : ", ") + one;
    throw InputError(fmt::format(
        "the ports differ: {}; write --tie INPUT=VALUE, --ignore OUTPUT or --map OLD=NEW", list));
  }
  if (!q.gold.clock.empty() && !q.gate.clock.empty() && q.gold.falling != q.gate.falling) {
    throw InputError("one takes over when its clock rises, the other when it falls");
  }
}

std::string word(const std::vector<bool>& values, const Widths& ports, const std::string& port,
                 const std::map<Name, std::size_t>& at) {
  std::string text;
  for (int bit = ports.at(port); bit-- > 0;) {
    const auto found = at.find({port, bit});
    text += found == at.end() ? '-' : values[found->second] ? '1' : '0';
  }
  return text;
}

// The clocks of a stimulus as words of ports.
void show(const Question& q, const Product& product, const proof::Reached& reached,
          Answer& answer) {
  std::vector<proof::Aig::Lit> watched;
  const auto watch = [&](const std::map<Name, proof::Aig::Lit>& bits) {
    std::map<Name, std::size_t> at;
    for (const auto& [name, lit] : bits) {
      at[name] = watched.size();
      watched.push_back(lit);
    }
    return at;
  };
  const auto inputs = watch(product.inputs), gold = watch(product.gold), gate = watch(product.gate),
             any = watch(product.any);
  for (const auto& values : product.graph.run(reached.inputs, watched)) {
    Row row;
    for (const auto& [port, width] : product.widths) {
      row.inputs[port] = word(values, product.widths, port, inputs);
    }
    for (const auto& [port, width] : q.gold.outputs) {
      const std::string other = gate_name(q, port);
      if (!q.gate.outputs.contains(other) || q.gate.outputs.at(other) != width) continue;
      row.gold[port] = word(values, q.gold.outputs, port, gold);
      row.gate[port] = word(values, q.gold.outputs, port, gate);
      for (int bit = 0; bit < width; ++bit) {
        const auto at = any.find({port, bit});
        if (at != any.end() && values[at->second]) {
          row.gold[port][static_cast<std::size_t>(width - 1 - bit)] = '-';
        }
      }
    }
    answer.clocks.push_back(row);
  }
  if (answer.clocks.empty()) return;
  const Row& last = answer.clocks.back();
  for (const auto& [port, text] : last.gold) {
    const std::string& other = last.gate.at(port);
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '-' || text[i] == other[i]) continue;
      answer.differing.push_back(port);
      break;
    }
  }
}

}  // namespace

Answer compare(const Question& q) {
  require_ports(q);
  Answer answer;
  // The registers that both have by name are equal nearly always: then one clock from any state is
  // all of the question.
  const Product cut = product_of(q, Registers::one, Unknown::same);
  answer.matched = cut.matched;
  if (q.latency == 0) {
    const proof::Reached step = proof::reach(cut.graph, cut.bad, std::min(q.seconds, 10));
    if (step.ever == proof::Ever::never) {
      answer.verdict = Verdict::equal;
      answer.by = cut.matched == 0 ? step.by : "registers by name, " + step.by;
      return answer;
    }
  }
  const bool old_unknown = q.gold.unknowns > 0 || cut.alone_any;
  for (const Unknown unknown : {Unknown::same, Unknown::any}) {
    if (unknown == Unknown::any && !old_unknown) break;
    const Product product = product_of(q, Registers::two, unknown);
    const proof::Reached reached = proof::reach(product.graph, product.bad, q.seconds);
    answer.by = reached.by;
    answer.compared = std::max(0, reached.clocks - q.reset_clocks);
    if (reached.ever == proof::Ever::never) {
      answer.verdict = Verdict::equal;
      return answer;
    }
    const bool last = unknown == Unknown::any || !old_unknown;
    if (reached.ever == proof::Ever::yes && last) {
      answer.verdict = Verdict::different;
      answer.least = reached.least;
      show(q, product, reached, answer);
      return answer;
    }
  }
  return answer;
}

}  // namespace cosim::equiv
