#include "tb/proof/rtl_nets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string_view>

#include "model/core/input_error.h"
#include "tb/nets/blif.h"
#include "tb/proof/gates.h"
#include "tb/proof/steps.h"
#include "tb/support/output_file.h"
#include "tb/support/process.h"
#include "tb/support/read_file.h"
#include "tb/support/words.h"

namespace cosim::proof {
namespace {

namespace fs = std::filesystem;

constexpr const char *kNets = "rtl.blif", *kWires = "rtl.wires", *kAsserts = "rtl.asserts";
constexpr const char *kUnmet = ".cosim_unmet", *kCovered = ".cosim_covered";

// For yosys: each assertion and each cover statement a net, where they are kept, and all else of
// that kind away.
std::string commands_for_stated(const Source& source, const fs::path& folder) {
  if (!source.keeps_statements) return "; chformal -remove";
  const std::string file = (folder / "stated.v").string();
  OutputFile out(file);
  out.text(R"((* techmap_celltype = "$assert" *)
module cosim_assert (input A, EN);
  (* keep *) wire cosim_unmet = EN & !A;
endmodule
(* techmap_celltype = "$cover" *)
module cosim_cover (input A, EN);
  (* keep *) wire cosim_covered = EN & A;
endmodule
)");
  out.close();
  return fmt::format("; techmap -map {}; chformal -remove", file);
}

// What is undefined in the RTL is free. What a gate leaves undefined, as a word that is not there,
// is 0.
std::string net_commands(const Source& source, const fs::path& folder) {
  return fmt::format("; select -write {} t:$assert t:$check", (folder / kAsserts).string()) +
         commands_for_stated(source, folder) + step_commands(source, folder) +
         "; async2sync; setundef -undriven -anyseq" + gate_commands(folder) +
         commands_to_write_nets(folder, "opt_expr; opt_clean; ");
}

}  // namespace

std::string commands_to_write_nets(const fs::path& folder, const std::string& cleaning) {
  return fmt::format(
      "; dfflegalize -cell $_DFF_P_ 01 -cell $_DFF_N_ 01; setundef -zero; {}setundef -undriven "
      "-zero; write_blif {}; dump -o {} w:*",
      cleaning, (folder / kNets).string(), (folder / kWires).string());
}
RtlNets written_nets(const fs::path& folder, const Source& source) {
  return {source.top, read_file((folder / kNets).string()), read_file((folder / kWires).string()),
          source.asynchronous_reset};
}

RtlNets::RtlNets(const Source& source)
    : RtlNets([&] {
        const Scratch scratch;
        run_yosys(flat_commands(source) + net_commands(source, scratch.path()), source.top);
        RtlNets nets = written_nets(scratch.path(), source);
        nets.asserts_ = !read_file((scratch.path() / kAsserts).string()).empty();
        if (!source.written.empty()) nets.arrays_ = declared_arrays(source.files);
        return nets;
      }()) {}

RtlNets::RtlNets(const std::string& top, const std::string& blif, const std::string& wires,
                 bool asynchronous_reset)
    : cells_(nets::read_blif(blif, top)) {
  for (std::size_t i = 0; i < cells_.nets.size(); ++i) numbers_[cells_.nets[i]] = i;
  read_wires(wires);
  find_flip_flops(asynchronous_reset);
}

// "  wire width 8 upto offset 1 output 3 \NAME"; what yosys made itself has no backslash.
void RtlNets::read_wires(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || word != "wire") continue;
    Wire wire;
    while (words >> word && word[0] != '\\' && word[0] != '$') {
      if (word == "width") words >> wire.width;
      if (word == "offset") words >> wire.first;
      if (word == "upto") wire.is_upward = true;
      if (word == "input" || word == "output" || word == "inout") wire.way = word;
    }
    if (word[0] == '\\') wires_[word.substr(1)] = wire;
  }
}

int RtlNets::width(const std::string& wire) const {
  const auto of = wires_.find(wire);
  return of == wires_.end() ? 0 : of->second.width;
}

// The smallest number that stands behind "memory[" in the names of the wires.
int RtlNets::first_word(const std::string& memory) const {
  const std::string begins = memory + '[';
  std::optional<int> first;
  for (auto wire = wires_.lower_bound(begins);
       wire != wires_.end() && wire->first.starts_with(begins); ++wire) {
    const int number = std::atoi(wire->first.c_str() + begins.size());
    first = std::min(first.value_or(number), number);
  }
  return first.value_or(0);
}

bool RtlNets::is_upward(const std::string& array) const {
  if (!arrays_) return false;
  const auto known = arrays_->find(array.substr(array.rfind('.') + 1));
  if (known == arrays_->end()) return false;  // parts of a vector
  if (known->second != Order::both) return known->second == Order::upward;
  throw InputError(
      fmt::format("{}: {}: two arrays of this name count upward and downward", cells_.name, array));
}

std::vector<std::string> RtlNets::inputs() const {
  std::set<std::string> clocks;
  for (const auto& f : cells_.flip_flops) clocks.insert(f.clock);
  std::vector<std::string> all;
  for (const auto& [name, wire] : wires_) {
    if (wire.way == "input" && !clocks.contains(name)) all.push_back(name);
  }
  return all;
}

std::vector<std::string> RtlNets::outputs() const {
  std::vector<std::string> all;
  for (const auto& [name, wire] : wires_) {
    if (wire.way == "output") all.push_back(name);
  }
  return all;
}

std::size_t RtlNets::net(const std::string& wire, int bit) const {
  const Wire& w = wires_.at(wire);
  const int index = w.first + (w.is_upward ? w.width - 1 - bit : bit);
  const std::string name = w.width == 1 ? wire : fmt::format("{}[{}]", wire, index);
  const auto found = numbers_.find(name);
  if (found == numbers_.end()) throw InputError(fmt::format("{}: no net {}", cells_.name, name));
  return found->second;
}

std::vector<std::pair<std::string, std::size_t>> RtlNets::unmet() const { return stated(kUnmet); }

std::vector<std::pair<std::string, std::size_t>> RtlNets::covered() const {
  return stated(kCovered);
}

std::vector<std::pair<std::string, std::size_t>> RtlNets::stated(const std::string& ending) const {
  std::vector<std::pair<std::string, std::size_t>> all;
  for (const auto& [name, net] : numbers_) {
    if (!name.ends_with(ending)) continue;
    // "$assert$FILE:LINE$NUMBER" where it has no label.
    std::string called = name.substr(0, name.size() - ending.size());
    if (called.starts_with('$')) {
      called.erase(0, called.find('$', 1) + 1);
      called.resize(std::min(called.rfind('$'), called.size()));
    }
    all.emplace_back(called, net);
  }
  return all;
}

std::vector<std::size_t> RtlNets::nets_in(const std::string& instance,
                                          const std::string& bit) const {
  std::vector<std::size_t> all;
  for (const auto& [name, net] : numbers_) {
    if (!name.ends_with(bit)) continue;
    const std::size_t path = name.size() - bit.size();
    if (path > 0 && name[path - 1] != '.') continue;
    if (is_like(name.substr(0, path == 0 ? 0 : path - 1), instance)) all.push_back(net);
  }
  return all;
}

bool RtlNets::is_sampled(std::size_t stated) const {
  std::vector<bool> is_read(cells_.nets.size());
  is_read[stated] = true;
  for (auto table = cells_.tables.rbegin(); table != cells_.tables.rend(); ++table) {
    if (!is_read[table->gives]) continue;
    for (const std::size_t net : table->of) is_read[net] = true;
  }
  const auto read = [&](std::size_t net) -> bool { return is_read[net]; };
  if (std::any_of(cells_.inputs.begin(), cells_.inputs.end(), read)) return false;
  return std::all_of(
      cells_.flip_flops.begin(), cells_.flip_flops.end(), [&](const nets::Cells::FlipFlop& f) {
        return !is_read[f.now] || cells_.nets[f.now].starts_with('$');  // yosys's own
      });
}

void RtlNets::find_flip_flops(bool asynchronous_reset) {
  constexpr std::uint64_t copies = 2;  // the table of a net that is another one
  shown_.resize(cells_.nets.size());
  for (std::size_t i = 0; i < cells_.flip_flops.size(); ++i) shown_[cells_.flip_flops[i].now] = i;
  std::vector<bool> many(cells_.nets.size());  // more than one
  for (const nets::Cells::Table& t : cells_.tables) {
    if (t.of.size() == 1 && t.table == copies) {
      shown_[t.gives] = shown_[t.of[0]];
      many[t.gives] = many[t.of[0]];
    } else if (asynchronous_reset) {
      for (const std::size_t net : t.of) {
        many[t.gives] = many[t.gives] || many[net] ||
                        (shown_[t.gives] && shown_[net] && shown_[t.gives] != shown_[net]);
        if (shown_[net]) shown_[t.gives] = shown_[net];
      }
    }
  }
  for (std::size_t i = 0; i < many.size(); ++i) {
    if (many[i]) shown_[i].reset();
  }
}

}  // namespace cosim::proof
