#include "tb/lanes/mapped.h"

#include <fmt/core.h>

#include <fstream>

#include "model/core/input_error.h"
#include "tb/support/process.h"
#include "tb/support/read_file.h"

namespace cosim::lanes {

nets::Cells mapped(const std::string& name, const nets::Graph& graph,
                   const std::vector<nets::Bit>& inputs, const std::vector<nets::Bit>& outputs) {
  const auto ports = [](const char* kind, const std::vector<nets::Bit>& bits) {
    std::vector<nets::Port> all;
    for (const nets::Bit bit : bits) all.push_back({fmt::format("{}{}", kind, all.size()), bit});
    return all;
  };
  const Scratch scratch;
  const auto given = scratch.path() / "given.blif", made = scratch.path() / "made.blif";
  std::ofstream(given) << to_blif(name, graph, ports("i", inputs), ports("o", outputs));
  const Ended ended = run_program(
      {"yosys-abc", "-q",
       fmt::format("read_blif {}; strash; dc2; dc2; dch; if -a -K 3; mfs2 -a; write_blif {}",
                   given.string(), made.string())});
  if (ended.status == 127) {
    throw InputError("lanes: need yosys-abc, which comes with yosys; --lanes 0 does without");
  }
  if (ended.status != 0 || !std::filesystem::exists(made)) {
    throw InputError(fmt::format("{}: yosys-abc fails: {}", name, ended.text));
  }
  nets::Cells cells = nets::read_blif(read_file(made.string()), name);
  if (cells.inputs.size() != inputs.size() || cells.outputs.size() != outputs.size()) {
    throw InputError(name + ": yosys-abc made another netlist");
  }
  return cells;
}

}  // namespace cosim::lanes
