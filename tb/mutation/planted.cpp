// All mutants are planted at once in one copy of the RTL, each turned on by its number (mutant
// schemata): it is read and made into nets once, not once a mutant.
#include "tb/mutation/subject.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "tb/util/output_file.h"
#include "tb/util/pattern.h"
#include "tb/util/process.h"
#include "tb/util/quoted.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::mutation {
namespace {

// Whether a mutant is of such a pin of a flip-flop or a memory.
bool is_of(const char* pins, const std::string& mutant) {
  const Pattern pin(std::string(R"(-port \\?)") + pins + ' ');
  return !pin.all(mutant).empty();
}
// A memory that is read without a clock, which has these pins too, is to have constants there.
constexpr const char* of_read_port = "RD_(EN|ARST|SRST)";
// That of one of several clocks is an enable in the nets, and another edge in the RTL.
constexpr const char* of_clock = "([A-Z]+_)?CLK";

}  // namespace

Planted::Planted(proof::Source source, unsigned count) : source_(std::move(source)) {
  const Scratch scratch;
  const std::string list = (scratch.path() / "all.txt").string();
  const std::string memories = (scratch.path() / "memories.txt").string();
  proof::run_yosys(prepared() + fmt::format("; mutate -list {} -seed 1 -o {}; select -write {} "
                                            "t:$mem_v2 r:WR_PORTS>1 %i",
                                            count, list, memories),
                   source_.top);
  // Where one write port comes before another, yosys takes none whose clock is another.
  std::vector<std::string> write_clocks;
  for (const std::string& name : lines_in(read_file(memories))) {
    write_clocks.push_back(fmt::format(" -cell {} -port WR_CLK ", name.substr(name.find('/') + 1)));
  }
  static const Pattern said(R"(^mutate |-module \S+ )");
  for (const std::string& line : lines_in(read_file(list))) {
    if (is_of(of_read_port, line)) continue;
    if (source_.clocks_are_inputs && is_of(of_clock, line)) continue;
    if (std::ranges::any_of(write_clocks,
                            [&](const auto& of) { return line.find(of) != std::string::npos; })) {
      continue;
    }
    static const Pattern place_in_file(R"( -src .*?:\d+\.\d+-\d+\.\d+)");
    commands_.push_back(place_in_file.replaced(line, ""));  // a path may have a blank
    std::string words = said.replaced(line, "");
    if (!source_.written.empty()) {  // places of the RTL follow those of what is written of it
      static const Pattern place(R"( -src /\S+|folder\d+/)");
      words = place.replaced(words, "");
    }
    for (const auto& file : source_.files) {
      // A mutant is known by the place in its file, wherever that lies.
      const std::string path = file.parent_path().parent_path().string() + '/';
      for (std::size_t at = 0; (at = words.find(path, at)) != std::string::npos;) {
        words.erase(at, path.size());
      }
    }
    mutants_.push_back(words);
  }
}

std::string Planted::prepared() const {
  std::string kept;
  for (const std::string& net : source_.kept) {
    kept += proof::kept_net(net.substr(net.rfind('.') + 1));
  }
  return fmt::format("{}; {}prep -flatten -top {}; chformal -remove; opt_clean",
                     proof::commands_to_elaborate(source_),
                     kept.empty() ? "" : fmt::format("setattr -set keep 1{}; ", kept), source_.top);
}

void Planted::run(const std::vector<unsigned>& numbers, const std::string& then) const {
  const Scratch scratch;
  const std::string script = (scratch.path() / "plant.ys").string();
  OutputFile file(script);
  for (const unsigned k : numbers) {
    file.text(fmt::format("{} -ctrl mutsel 16 {}\n", commands_.at(k - 1), k));
  }
  file.close();
  proof::run_yosys(fmt::format("{}; script {}; opt_clean; {}", prepared(), script, then),
                   source_.top);
}

// No cell is optimised: it takes longer than what comes of it saves.
proof::RtlNets Planted::nets(const std::vector<unsigned>& numbers) const {
  const Scratch scratch;
  run(numbers, "memory_collect; memory_map" + proof::command_to_write_nets(scratch.path()));
  return proof::written_nets(scratch.path(), source_);
}

void Planted::write_verilog(const std::vector<unsigned>& numbers,
                            const std::filesystem::path& file) const {
  run(numbers, "write_verilog -noattr " + word_for_yosys(file.string()));
}

}  // namespace cosim::mutation
