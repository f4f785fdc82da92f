#include "tb/equiv/clocks.h"

#include <algorithm>

#include "tb/nets/runs.h"

namespace cosim::equiv {
namespace {

using Widths = std::map<std::string, int>;

std::string word(const std::vector<bool>& values, const Widths& ports, const std::string& port,
                 const std::map<Name, std::size_t>& at) {
  std::string text;
  for (int bit = ports.at(port); bit-- > 0;) {
    const auto found = at.find({port, bit});
    text += found == at.end() ? '-' : values[found->second] ? '1' : '0';
  }
  return text;
}

// Bit by bit, whether what the old RTL has is another value.
bool differ(const std::string& gold, const std::string& gate) {
  for (std::size_t i = 0; i < gold.size(); ++i) {
    if (gold[i] != '-' && gold[i] != gate[i]) return true;
  }
  return false;
}

void name_differing(Answer& answer) {
  answer.differing.clear();
  const Row& last = answer.clocks.back();
  for (const auto& [port, text] : last.gold) {
    if (differ(text, last.gate.at(port))) answer.differing.push_back(port);
  }
}

// The values of an output from clock `first` on, each with the clock on which it begins.
struct Step {
  std::string value;
  int clock = 0;
};
std::vector<Step> steps(const std::vector<std::string>& values, std::size_t first) {
  std::vector<Step> all;
  for (std::size_t i = first; i < values.size(); ++i) {
    if (all.empty() || all.back().value != values[i])
      all.push_back({values[i], static_cast<int>(i)});
  }
  return all;
}

// How much later the new values come; none where they are not the same in order.
std::optional<int> lateness(const std::vector<std::string>& gold,
                            const std::vector<std::string>& gate, std::size_t first) {
  const auto olds = steps(gold, first), news = steps(gate, first);
  const std::size_t both = std::min(olds.size(), news.size());
  for (std::size_t i = 0; i < both; ++i) {
    if (olds[i].value != news[i].value) return {};
  }
  for (std::size_t i = 0; i < both; ++i) {
    if (olds[i].clock != news[i].clock) return news[i].clock - olds[i].clock;
  }
  return {};  // one has not come to it
}

}  // namespace

std::string gate_name(const Question& q, const std::string& port) {
  const auto at = q.renamed.find(port);
  return at == q.renamed.end() ? port : at->second;
}

std::string gold_name(const Question& q, const std::string& port) {
  for (const auto& [old_name, new_name] : q.renamed) {
    if (new_name == port) return old_name;
  }
  return port;
}

std::optional<bool> tied_bit(const Question& q, const Name& name) {
  const auto at = q.tied.find(name.first);
  if (at == q.tied.end()) return {};
  const auto bit = static_cast<std::size_t>(name.second);
  return bit < at->second.size() && at->second[at->second.size() - 1 - bit] == '1';
}

std::size_t first_compared(const Question& q) {
  return static_cast<std::size_t>(q.reset_clocks) + static_cast<std::size_t>(q.latency);
}

std::uint64_t first_drawn(const Question& q, const Answer& answer) {
  const std::uint64_t clock = answer.clocks.size() - 1;
  return clock > q.wave_before ? clock - q.wave_before : 0;
}

void show(const Question& q, const Product& product, const proof::Reached& reached,
          const std::set<Name>& open, Answer& answer) {
  answer.verdict = Verdict::different;
  Bits watched;
  const auto watch = [&](const std::map<Name, Bit>& bits) {
    std::map<Name, std::size_t> at;
    for (const auto& [name, lit] : bits) {
      at[name] = watched.size();
      watched.push_back(lit);
    }
    return at;
  };
  const auto inputs = watch(product.inputs), gold = watch(product.gold), gate = watch(product.gate),
             any = watch(product.any);
  const std::size_t held = watched.size();
  watched.push_back(product.held);
  const auto begins = [&](const Bits& lits) {
    std::string digits;
    auto known = lits;
    std::replace(known.begin(), known.end(), unknown_begin, no);
    const auto values = nets::traced(product.graph, {reached.inputs.front()}, known).front();
    for (std::size_t i = 0; i < lits.size(); ++i) {
      digits += lits[i] == unknown_begin ? 'x' : values[i] ? '1' : '0';
    }
    return digits;
  };
  answer.gold_begins = begins(product.gold_begins);
  answer.gate_begins = begins(product.gate_begins);
  auto inputs_of_all = reached.inputs;
  inputs_of_all.resize(inputs_of_all.size() + clocks_behind, reached.inputs.back());
  for (const auto& values : nets::traced(product.graph, inputs_of_all, watched)) {
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
        if (open.contains({port, bit}) || (at != any.end() && values[at->second])) {
          row.gold[port][static_cast<std::size_t>(width - 1 - bit)] = '-';
        }
      }
    }
    if (answer.clocks.size() == reached.inputs.size() && !values[held]) break;
    auto& rows = answer.clocks.size() < reached.inputs.size() ? answer.clocks : answer.after;
    rows.push_back(std::move(row));
  }
  name_differing(answer);
}

void take_over(const Question& q, const Replay& replay, Answer& answer) {
  const auto latency = static_cast<std::size_t>(q.latency);
  std::size_t clock = 0;
  for (auto* rows : {&answer.clocks, &answer.after}) {
    for (Row& row : *rows) {
      std::size_t i = 0;
      for (auto& [port, text] : row.gold) {
        if (clock < replay.gate.outputs.size()) row.gate[port] = replay.gate.outputs[clock].at(i);
        if (clock >= latency && clock - latency < replay.gold.outputs.size()) {
          const std::string& old = replay.gold.outputs[clock - latency].at(i);
          for (std::size_t bit = 0; bit < text.size(); ++bit) {
            const bool is_x = old[bit] != '0' && old[bit] != '1';
            if (text[bit] != '-') text[bit] = is_x ? '-' : old[bit];
          }
        }
        ++i;
      }
      ++clock;
    }
  }
  name_differing(answer);
  answer.recorded = {replay.gold.vcd, replay.gate.vcd};
}

std::vector<Late> late_outputs(const Question& q, const Answer& answer) {
  std::vector<Late> all;
  const std::size_t first = first_compared(q);
  for (const auto& [port, last] : answer.clocks.back().gold) {
    std::vector<std::string> gold, gate;
    bool same = true;
    for (const auto* rows : {&answer.clocks, &answer.after}) {
      for (const Row& row : *rows) {
        gold.push_back(row.gold.at(port));
        gate.push_back(row.gate.at(port));
        if (gold.size() > first) same = same && !differ(gold.back(), gate.back());
      }
    }
    if (same) continue;
    const bool has_x =
        std::any_of(gold.begin() + static_cast<std::ptrdiff_t>(first), gold.end(),
                    [](const std::string& text) { return text.find('-') != std::string::npos; });
    const auto late = has_x ? std::nullopt : lateness(gold, gate, first);
    if (!late) return {};
    all.push_back({port, *late});
  }
  return all;
}

}  // namespace cosim::equiv
