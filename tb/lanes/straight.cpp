// Only what something compared, counted or stored needs is written (dead code elimination, from the
// last value to the first). A cell of three inputs is one instruction with a table of truth, which
// puts its result in place of its last input: inputs change places, and the table with them, so
// that this is one that no register has to hold any more.
#include "tb/lanes/code.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "model/core/input_error.h"
#include "tb/lanes/schedule.h"

namespace cosim::lanes {
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
  if (inputs.size() != cells.inputs.size()) {
    throw InputError(cells.name + ": a netlist of other inputs");
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

std::vector<Straight::Merged> Straight::merge(std::size_t first) {
  std::vector<Merged> merged;
  std::map<Value, Value> instead;  // of the planes that are merged
  std::map<std::size_t, Value> stored;
  for (const Use& u : stores_) stored[u.number] = u.value;
  const auto is_free = [&](Value v) {
    return cells_[v].is_plane && cells_[v].plane >= first && stored.count(cells_[v].plane) != 0 &&
           instead.count(v) == 0;
  };
  std::erase_if(comparisons_, [&](const Comparison& c) {
    if (c.when != one || !is_free(c.a) || !is_free(c.b)) return false;
    merged.push_back({cells_[c.a].plane, cells_[c.b].plane});
    instead[c.a] = instead[c.b] = c.a;
    return true;
  });
  for (const Merged& m : merged) {
    comparisons_.push_back({stored[m.kept], stored[m.dropped], one, true});
    std::erase_if(stores_, [&](const Use& u) { return u.number == m.dropped; });
  }
  const auto replace = [&](Value& v) { v = instead.count(v) != 0 ? instead[v] : v; };
  for (Cell& cell : cells_) std::ranges::for_each(cell.of, replace);
  for (Comparison& c : comparisons_) {
    for (Value* v : {&c.a, &c.b, &c.when}) replace(*v);
  }
  for (auto* uses : {&stores_, &counts_}) {
    for (Use& u : *uses) replace(u.value);
  }
  return merged;
}

namespace {

// The same table with the input at `place` and the last one in each other's place.
std::uint8_t with_last(std::uint8_t table, std::size_t place) {
  std::uint8_t turned = 0;
  for (std::size_t row = 0; row < 8; ++row) {
    const std::size_t near = row >> place & 1, far = row >> 2 & 1;
    const std::size_t from =
        (row & ~(std::size_t{4} | std::size_t{1} << place)) | near << 2 | far << place;
    turned = static_cast<std::uint8_t>(turned | (table >> from & 1U) << row);
  }
  return turned;
}

}  // namespace

/// Its statements, and their words.
class Straight::Writer {
 public:
  explicit Writer(const Straight& code)
      : code_(code), values_(code.cells_.size()), is_needed_(values_), readers_(values_) {
    need();
    for (Value v = 2; v < values_; ++v) {
      if (is_needed_[v] && !code.cells_[v].is_plane)
        add({code.cells_[v].of.begin(), code.cells_[v].of.end()}, v, {Kind::cell, v});
    }
    for (std::size_t i = 0; i < code.comparisons_.size(); ++i) {
      const Comparison& c = code.comparisons_[i];
      add({c.a, c.b, c.when}, Statement::none, {Kind::comparison, i});
    }
    for (std::size_t i = 0; i < code.counts_.size(); ++i) {
      add({code.counts_[i].value}, Statement::none, {Kind::count, i});
    }
    for (std::size_t i = 0; i < code.stores_.size(); ++i) {
      // A plane that goes to another is taken first, so that two can change places.
      Value value = code.stores_[i].value;
      if (code.cells_[value].is_plane) {
        taken_.push_back(value);
        add({value}, values_ + taken_.size() - 1, {Kind::take, taken_.size() - 1});
        value = values_ + taken_.size() - 1;
      }
      add({value}, Statement::none, {Kind::store, i});
    }
    for (std::size_t s = 0; s < kinds_.size(); ++s) {
      if (kinds_[s].first != Kind::store) continue;
      const auto held = code.planes_.find(code.stores_[kinds_[s].second].number);
      if (held != code.planes_.end()) statements_[s].after = readers_[held->second];
    }
  }

  std::string text(std::size_t registers) {
    const Schedule schedule = scheduled(statements_, values_ + taken_.size(), registers);
    left_.assign(values_ + taken_.size(), 0);
    for (const Statement& s : statements_) {
      for (const std::size_t v : s.reads) ++left_[v];
    }
    loaded_.assign(left_.size(), 0);
    std::string all = fmt::format("  V t[{}];\n", std::max<std::size_t>(schedule.places, 1));
    auto before = Move::What::run;
    for (const Move& move : schedule.moves) {
      switch (move.what) {
        case Move::What::run:
          all += "  " + line(move.of) + '\n';
          for (const std::size_t v : statements_[move.of].reads) --left_[v];
          leaving_.clear();
          break;
        case Move::What::load: {
          const std::string from = move.place == Statement::none
                                       ? fmt::format("M({})", code_.cells_[move.of].plane)
                                       : fmt::format("t[{}]", move.place);
          ++loaded_[move.of];
          // An instruction takes one that nothing stands between.
          if (before != Move::What::load) all += "  FORGET;\n";
          all += fmt::format("  const V {} = {};\n", name(move.of), from);
          break;
        }
        case Move::What::leave:
          leaving_.insert(move.of);
          if (move.place != Statement::none) {
            all += fmt::format("  t[{}] = {};\n", move.place, name(move.of));
          }
      }
      before = move.what;
    }
    return all;
  }

 private:
  enum class Kind { cell, take, comparison, count, store };

  // The cells that what is compared, counted and stored comes from.
  void need() {
    const auto all = [&](Value v) { is_needed_[v] = true; };
    for (const Comparison& c : code_.comparisons_) {
      for (const Value v : {c.a, c.b, c.when}) all(v);
    }
    for (const Use& u : code_.counts_) all(u.value);
    for (const Use& u : code_.stores_) all(u.value);
    for (Value v = values_; v-- > 2;) {
      if (!is_needed_[v]) continue;
      for (const Value of : code_.cells_[v].of) all(of);
    }
  }

  void add(const std::vector<Value>& reads, std::size_t gives,
           const std::pair<Kind, std::size_t>& kind) {
    Statement s{{}, gives};
    for (const Value v : reads) {
      const bool is_new = std::ranges::find(s.reads, v) == s.reads.end();
      if (v > one && is_new) s.reads.push_back(v);
    }
    for (const Value v : s.reads) {
      if (v < values_ && code_.cells_[v].is_plane) readers_[v].push_back(statements_.size());
    }
    statements_.push_back(std::move(s));
    kinds_.push_back(kind);
  }

  std::string name(Value v) const {
    if (v == zero) return "Z";
    if (v == one) return "O";
    return loaded_[v] == 0 ? fmt::format("v{}", v) : fmt::format("v{}_{}", v, loaded_[v]);
  }

  std::string line(std::size_t s) const {
    const auto [kind, i] = kinds_[s];
    switch (kind) {
      case Kind::cell:
        return cell(i);
      case Kind::take:
        return fmt::format("const V v{} = {};", values_ + i, name(taken_[i]));
      case Kind::comparison: {
        const auto& [a, b, when, is_late] = code_.comparisons_[i];
        const char* all = is_late ? "late" : "differ";
        return when == one ? fmt::format("{0} = T(0xf6, {1}, {2}, {0});", all, name(a), name(b))
                           : fmt::format("differ |= ({} ^ {}) & {};", name(a), name(b), name(when));
      }
      case Kind::count:
        return fmt::format("left_out[{}] += count(active & ~{});", code_.counts_[i].number,
                           name(code_.counts_[i].value));
      case Kind::store:
        break;
    }
    const Use& u = code_.stores_[i];
    const auto& reads = statements_[s].reads;
    return fmt::format("M({}) = {};", u.number, name(reads.empty() ? u.value : reads.front()));
  }
  // An instruction of three inputs puts its result in place of the last: best one that no register
  // has to hold any more.
  bool is_free(Value v) const { return v > one && (left_[v] == 1 || leaving_.count(v) != 0); }
  std::string cell(Value v) const {
    auto [table, of, plane, is_plane] = code_.cells_[v];
    for (const std::size_t place : {1U, 0U}) {
      if (is_free(of[2]) || !is_free(of[place])) continue;
      std::swap(of[place], of[2]);
      table = with_last(table, place);
    }
    return fmt::format("const V v{} = T(0x{:02x}, {}, {}, {});", v, table, name(of[0]), name(of[1]),
                       name(of[2]));
  }

  const Straight& code_;
  const std::size_t values_;
  std::vector<bool> is_needed_;
  std::vector<std::vector<std::size_t>> readers_;  // of a plane's value: statements
  std::vector<Value> taken_;                       // values behind values_: of these planes
  std::vector<Statement> statements_;
  std::vector<std::pair<Kind, std::size_t>> kinds_;  // of each, and which of its kind
  std::vector<std::size_t> left_, loaded_;  // by value: reads to come, and how often it was loaded
  std::set<Value> leaving_;                 // behind the next statement
};

std::string Straight::text(std::size_t registers) const { return Writer(*this).text(registers); }

}  // namespace cosim::lanes
