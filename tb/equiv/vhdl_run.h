// VHDL run by GHDL itself: what its outputs are says how the Verilog that is made of it is to be
// judged.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cosim::equiv {

/// The inputs of each clock. Names are those of the entity's ports, in any case.
struct VhdlStimulus {
  std::vector<std::string> clocks;
  std::map<std::string, bool> falls;                ///< a clock in it with true has a falling edge
  std::vector<std::pair<std::string, int>> inputs;  ///< and their widths, without the clocks
  std::vector<std::pair<std::string, int>> outputs;
  /// One a clock: for each of `clocks` 1 if it has its edge, then the bits of the inputs, the
  /// highest first; x is an unknown one.
  std::vector<std::string> rows;
};

struct VhdlRun {
  /// The rows of the stimulus as they were run: an integer outside the range of its port is wrapped
  /// into it, an x of a port that has none is 0. Fewer than asked for where `error` says why.
  std::vector<std::string> inputs;
  /// For each of them the bits of all outputs, 0, 1 or x, the highest first.
  std::vector<std::string> rows;
  std::string error;  ///< one line; empty if all rows were run
};

/// Runs `top` with the generics "NAME=VALUE". In each row the inputs are set while the clocks rest,
/// 1 us later the outputs are read, then the clocks have their edges together, 1 us later they go
/// back, and 1 us later the next row begins. The files may be in any order. Ports of types other
/// than std_logic, std_logic_vector, unsigned, signed, bit, bit_vector, boolean and integers are an
/// error, as is VHDL that does not elaborate. An integer is in two's complement if its range begins
/// below 0.
VhdlRun run_vhdl(const std::vector<std::string>& files, const std::string& top,
                 const std::vector<std::string>& generics, const VhdlStimulus& stimulus,
                 std::chrono::steady_clock::time_point until);

// The declaration of an entity of VHDL, as a text: what a testbench repeats.

struct VhdlPort {
  std::string name;
  std::string mode;  ///< in small letters: in, out, inout, buffer or linkage
  std::string type;  ///< with its constraint, without a default
};

struct VhdlEntity {
  std::string name;
  std::string context;   ///< its library and use clauses
  std::string generics;  ///< their declarations, between the brackets
  std::vector<std::string> generic_names;
  std::vector<VhdlPort> ports;
};

/// The same in small letters: VHDL knows no others.
std::string small_letters(std::string text);

/// The entity of that name, in any case, in the text of a file.
std::optional<VhdlEntity> entity_in(std::string_view text, const std::string& name);

}  // namespace cosim::equiv
