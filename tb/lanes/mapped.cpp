#include "tb/lanes/code.h"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "model/core/input_error.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"

namespace cosim::lanes {
namespace {

// How many instructions it is at least: a cell of one input is none.
std::size_t size_of(const nets::Cells& cells) {
  return static_cast<std::size_t>(
      std::ranges::count_if(cells.tables, [](const auto& t) { return t.of.size() > 1; }));
}

}  // namespace

nets::Cells mapped(const std::string& name, const nets::Graph& graph,
                   const std::vector<nets::Bit>& inputs, const std::vector<nets::Bit>& outputs) {
  nets::Graph own;  // with these inputs alone, in their order
  nets::Placing placing(graph, own);
  for (const nets::Bit bit : inputs) placing.give(bit, own.input());
  placing.make(outputs);
  nets::Bits made;
  for (const nets::Bit bit : outputs) made.push_back(placing.of(bit));
  const Scratch scratch;
  const auto file = [&](const char* of) { return (scratch.path() / of).string(); };
  std::ofstream(file("given.aig")) << aiger(own, made);
  // Which of two ways needs fewer cells depends on the netlist. mfs2 takes most of the time.
  const std::string read = "read_aiger " + file("given.aig") + "; strash; ", map = "if -a -K 3; ";
  const std::string again = "strash; dch; " + map, ends = again + "mfs2 -a; write_blif ";
  const std::vector<std::string> all{file("0.blif"), file("1.blif")};
  const Ended ended = run_program(
      {"yosys-abc", "-q",
       read + "ifraig; " + map + again + ends + all[0] + "; " + read + "dc2; " + ends + all[1]});
  if (ended.status == 127) {
    throw InputError("lanes: need yosys-abc, which comes with yosys; --lanes 0 runs without it");
  }
  if (ended.status != 0 || !std::filesystem::exists(all.back())) {
    throw InputError(fmt::format("{}: yosys-abc fails: {}", name, ended.text));
  }
  nets::Cells cells = nets::read_blif(read_file(all.front()), name);
  for (const std::string& path : all) {
    nets::Cells other = nets::read_blif(read_file(path), name);
    if (size_of(other) < size_of(cells)) cells = std::move(other);
  }
  if (cells.inputs.size() != inputs.size() || cells.outputs.size() != outputs.size()) {
    throw InputError(name + ": yosys-abc made another netlist");
  }
  return cells;
}

}  // namespace cosim::lanes
