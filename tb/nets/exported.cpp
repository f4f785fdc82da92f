#include "tb/nets/exported.h"

#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include "model/core/input_error.h"
#include "tb/nets/btor2.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::nets {

const Btor2& exported_model(const std::string& path) {
  static std::mutex mutex;
  static std::map<std::string, Btor2> all;
  const std::lock_guard lock(mutex);
  const auto found = all.find(path);
  if (found != all.end()) return found->second;
  std::ifstream file(path);
  if (!file) throw InputError(path + ": the model was not exported");
  std::ostringstream text;
  text << file.rdbuf();
  static const std::string error = "; error: ";
  if (text.str().starts_with(error)) {
    throw InputError(text.str().substr(error.size(), text.str().find('\n') - error.size()));
  }
  return all.emplace(path, read_btor2(text.str(), path)).first->second;
}

}  // namespace cosim::nets

namespace cosim::clocked {
namespace {

using nets::Bit;
using nets::Bits;
using nets::Btor2;
using nets::Graph;
using nets::Number;
using nets::Truth;
using Cells = SymbolsOf<Number>::Cells;

// Words of a wide number follow each other.
bool goes_on(const Field& field) { return field.is_word && field.index > 0; }

Bits code_of(const SymbolCell<Number>& cell, bool is_number) {
  const Field& f = cell.field;
  if (is_number && f.format == Format::ones_complement) {
    return to_ones_complement(cell.value, f.width).code(f.width);
  }
  return cell.value.code(f.width);
}
// Of the cells as `names` has them, each with all its words.
std::vector<Bits> codes(const Cells& cells, const std::vector<Btor2::Name>& names,
                        bool are_numbers) {
  std::vector<Bits> all;
  for (const auto& cell : cells) {
    if (!goes_on(cell.field)) all.emplace_back();
    const Bits code = code_of(cell, are_numbers);
    all.back().insert(all.back().end(), code.begin(), code.end());
  }
  bool same = all.size() == names.size();
  for (std::size_t i = 0; same && i < all.size(); ++i) {
    same = static_cast<int>(all[i].size()) == names[i].width;
  }
  if (!same) throw std::logic_error("an exported model is not that of its design");
  return all;
}

Number number_of(Graph& graph, const Field& field, const Bits& code, bool is_number) {
  Number n = Number::unsigned_code(graph, code);
  if (is_number && field.format == Format::twos_complement) n = Number::signed_code(graph, code);
  if (is_number && field.format == Format::ones_complement) {
    n = from_ones_complement(n, field.width);
  }
  if (const auto known = n.known()) return {*known};  // it may outlive the graph
  return n;
}

// What a section gives, each with all its words, in a graph: that of the values, or `spare`.
std::vector<Bits> gives(const Asked<Number>& asked, const std::string& section, Graph& spare,
                        Graph*& graph) {
  const Btor2& model = nets::exported_model(asked.file + ".btor2");
  graph = &spare;
  for (const Cells* cells : {&asked.inputs, &asked.states}) {
    for (const auto& cell : *cells) {
      if (cell.value.graph() != nullptr) graph = cell.value.graph();
    }
  }
  const auto inputs = codes(asked.inputs, model.inputs, false);
  const auto states = codes(asked.states, model.states, true);
  auto clock = nets::placed(*graph, model, inputs, states);
  if (section == "next") return clock.next;
  std::vector<Bits> all;
  for (std::size_t i = 0; i < model.outputs.size(); ++i) {
    const std::string& name = model.outputs[i].name;
    // "cases:0", but not the slice "status[7:0]" of an output.
    const std::size_t end = name.find_first_of("[:");
    const std::size_t colon =
        end != std::string::npos && name[end] == ':' ? end : std::string::npos;
    const bool is_own =
        section == "out" ? colon == std::string::npos : name.substr(0, colon) == section;
    if (is_own) all.push_back(clock.outputs[i]);
  }
  return all;
}

}  // namespace

void SymbolsOf<Number>::give(const Question& asked, const std::string& section, Cells& wanted) {
  Graph spare;
  Graph* graph = nullptr;
  const auto all = gives(asked, section, spare, graph);
  std::size_t next = 0, from = 0;
  for (auto& [field, value] : wanted) {
    from = goes_on(field) ? from : 0;
    next += goes_on(field) ? 0 : 1;
    const auto begin = all.at(next - 1).begin() + static_cast<std::ptrdiff_t>(from);
    value = number_of(*graph, field, {begin, begin + field.width}, section == "next");
    from += static_cast<std::size_t>(field.width);
  }
}

std::vector<Truth> SymbolsOf<Number>::conditions(const Question& asked,
                                                 const std::string& section) {
  Graph spare;
  Graph* graph = nullptr;
  std::vector<Truth> all;
  for (const Bits& bit : gives(asked, section, spare, graph)) {
    all.push_back(bit[0].is_constant() ? Truth(bit[0] == nets::yes) : Truth(*graph, bit[0]));
  }
  return all;
}

std::vector<std::pair<std::string, Truth>> SymbolsOf<Number>::ways(const Question& asked) {
  const auto taken = conditions(asked, "ways");
  std::vector<std::pair<std::string, Truth>> all;
  for (const std::string& line : lines_in(read_file(asked.file + ".btor2"))) {
    if (!line.starts_with("; ways:")) continue;
    all.emplace_back(line.substr(line.find('\t') + 1), taken.at(all.size()));
  }
  return all;
}

}  // namespace cosim::clocked
