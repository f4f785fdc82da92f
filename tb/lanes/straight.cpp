#include "tb/lanes/straight.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"

namespace cosim::lanes {
namespace {

std::string name_of(Value v) {
  if (v == zero) return "Z";
  if (v == one) return "O";
  return fmt::format("v{}", v);
}

}  // namespace

Value Straight::plane(std::size_t i) {
  const auto [at, is_new] = planes_.try_emplace(i, cells_.size());
  if (is_new) cells_.push_back({0, {}, i, true});
  return at->second;
}

Value Straight::cell(std::uint8_t table, Value a, Value b, Value c) {
  cells_.push_back({table, {a, b, c}});
  return cells_.size() - 1;
}

std::vector<Value> Straight::add(const nets::Cells& cells, std::span<const Value> inputs) {
  if (!cells.flip_flops.empty() || !cells.free.empty() || inputs.size() != cells.inputs.size()) {
    throw InputError(cells.name + ": not a netlist of tables alone");
  }
  std::vector<Value> values(cells.nets.size(), zero);
  for (std::size_t i = 0; i < inputs.size(); ++i) values[cells.inputs[i]] = inputs[i];
  for (const auto& t : cells.tables) {
    if (t.of.size() > 3) throw InputError(cells.name + ": a cell of more than three inputs");
    std::array<Value, 3> of{};
    for (std::size_t i = 0; i < t.of.size(); ++i) of[i] = values[t.of[i]];
    std::uint8_t table = 0;
    const std::size_t rows = std::size_t{1} << t.of.size();
    for (std::size_t i = 0; i < 8; ++i) {
      if ((t.table >> (i % rows) & 1) != 0) table = static_cast<std::uint8_t>(table | 1U << i);
    }
    Value& gives = values[t.gives];
    if (table == 0 || table == 0xff) {
      gives = table == 0 ? zero : one;
    } else if (t.of.size() == 1 && (t.table & 3) == 2) {
      gives = of[0];
    } else {
      gives = cell(table, of[0], of[1], of[2]);
    }
  }
  std::vector<Value> outputs;
  for (const std::size_t net : cells.outputs) outputs.push_back(values[net]);
  return outputs;
}

void Straight::compare(Value a, Value b, Value when) {
  if (a != b) comparisons_.push_back({a, b, when});
}

// How many values are alive at most while a value is made, the one that needs most made first.
std::vector<std::size_t> Straight::needs() const {
  std::vector<std::size_t> all(cells_.size(), 1);
  for (Value v = 2; v < cells_.size(); ++v) {
    if (cells_[v].is_plane) continue;
    std::array<std::size_t, 3> of{};
    for (std::size_t i = 0; i < of.size(); ++i) of[i] = all[cells_[v].of[i]];
    std::sort(of.begin(), of.end());
    all[v] = std::max({of[2], of[1] + 1, of[0] + 2});
  }
  return all;
}

// What is needed, each behind what it reads; what one root needs close together, so that few values
// are alive at a time.
std::vector<Value> Straight::order() const {
  const std::vector<std::size_t> need = needs();
  std::vector<Value> ordered;
  std::vector<bool> done(cells_.size());
  done[zero] = done[one] = true;
  const auto visit = [&](Value root) {
    std::vector<Value> stack{root};
    while (!stack.empty()) {
      const Value v = stack.back();
      const Cell& c = cells_[v];
      Value next = zero;
      for (const Value i : c.of) {
        if (!done[i] && (next == zero || need[i] > need[next])) next = i;
      }
      if (done[v]) {
        stack.pop_back();
      } else if (next != zero) {
        stack.push_back(next);
      } else {
        done[v] = true;
        ordered.push_back(v);
        stack.pop_back();
      }
    }
  };
  for (const Comparison& c : comparisons_) {
    for (const Value v : {c.a, c.b, c.when}) visit(v);
  }
  for (const Use& u : counts_) visit(u.value);
  for (const Use& u : stores_) visit(u.value);
  return ordered;
}

std::size_t Straight::cells() const {
  const auto all = order();
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [&](Value v) { return !cells_[v].is_plane; }));
}

// The same cell with an input in the last place that is not needed any more: an instruction of
// three inputs puts its result in place of that one.
template <class IsFree>
Straight::Cell Straight::with_last(const Cell& c, IsFree is_free) {
  for (std::size_t place : {1U, 0U}) {
    if (is_free(c.of[2]) || !is_free(c.of[place])) continue;
    Cell turned = c;
    std::swap(turned.of[place], turned.of[2]);
    turned.table = 0;
    for (std::size_t row = 0; row < 8; ++row) {
      const std::size_t near = row >> place & 1, far = row >> 2 & 1;
      const std::size_t from =
          (row & ~(std::size_t{4} | std::size_t{1} << place)) | near << 2 | far << place;
      turned.table = static_cast<std::uint8_t>(turned.table | (c.table >> from & 1U) << row);
    }
    return turned;
  }
  return c;
}

std::string Straight::text() const {
  const std::vector<Value> ordered = order();
  std::vector<std::size_t> position(cells_.size(), 0);
  for (std::size_t i = 0; i < ordered.size(); ++i) position[ordered[i]] = i;
  // Something becomes of a value as soon as it is there: a comparison at once, a store when what
  // the plane held is no longer read.
  std::vector<std::vector<std::string>> then(ordered.size() + 1);
  const auto behind = [&](Value v) { return v > one ? position[v] + 1 : 0; };
  std::map<std::size_t, std::size_t> last_read;  // by plane
  const auto reads = [&](Value v, std::size_t at) {
    if (cells_[v].is_plane) last_read[cells_[v].plane] = std::max(last_read[cells_[v].plane], at);
  };
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    for (const Value v : cells_[ordered[i]].of) reads(v, i + 1);
  }
  for (const Comparison& c : comparisons_) {
    const std::size_t at = std::max({behind(c.a), behind(c.b), behind(c.when)});
    for (const Value v : {c.a, c.b, c.when}) reads(v, at);
    then[at].push_back(
        c.when == one ? fmt::format("differ = T<0xf6>({}, {}, differ);", name_of(c.a), name_of(c.b))
                      : fmt::format("differ |= ({} ^ {}) & {};", name_of(c.a), name_of(c.b),
                                    name_of(c.when)));
  }
  for (const Use& u : counts_) {
    const std::size_t at = behind(u.value);
    reads(u.value, at);
    then[at].push_back(
        fmt::format("left_out[{}] += count(active & ~{});", u.number, name_of(u.value)));
  }
  for (const Use& u : stores_) reads(u.value, behind(u.value));
  for (const Use& u : stores_) {
    const auto held = last_read.find(u.number);
    const std::size_t at = std::max(behind(u.value), held == last_read.end() ? 0 : held->second);
    then[at].push_back(fmt::format("m[{}] = {};", u.number, name_of(u.value)));
  }

  std::vector<std::size_t> last_use(cells_.size(), 0);
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    for (const Value v : cells_[ordered[i]].of) last_use[v] = i + 1;
  }
  for (const Comparison& c : comparisons_) {
    for (const Value v : {c.a, c.b, c.when}) last_use[v] = ordered.size() + 1;
  }
  for (const auto* uses : {&counts_, &stores_}) {
    for (const Use& u : *uses) last_use[u.value] = ordered.size() + 1;
  }

  std::string text;
  for (std::size_t i = 0; i <= ordered.size(); ++i) {
    for (const std::string& line : then[i]) text += "  " + line + '\n';
    if (i == ordered.size()) break;
    const Value v = ordered[i];
    const Cell& c = cells_[v];
    if (c.is_plane) {
      text += fmt::format("  const V v{} = m[{}];\n", v, c.plane);
      continue;
    }
    const Cell turned = with_last(c, [&](Value of) { return last_use[of] == i + 1; });
    text += fmt::format("  const V v{} = T<0x{:02x}>({}, {}, {});\n", v, turned.table,
                        name_of(turned.of[0]), name_of(turned.of[1]), name_of(turned.of[2]));
  }
  return text;
}

}  // namespace cosim::lanes
