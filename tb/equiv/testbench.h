// A testbench that gives the source of one of two RTLs a stimulus and prints what it does.
//
// A clock takes two microseconds: the inputs, a microsecond later the outputs are printed, then the
// clock goes there and back. Before the first one the inputs are as in row 0, which is no clock,
// and registers are given values.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tb/equiv/side.h"

namespace cosim::equiv {

/// What one clock takes, and when the outputs are what they are on clock 0.
inline constexpr std::uint64_t clock_ps = 2'000'000, settled_ps = 3'000'000;

/// A variable of the RTL below the top: "u.count".
struct Variable {
  std::string name;
  std::string value;              ///< that it is given, binary; empty: none
  std::size_t at = 0, width = 0;  ///< its digits in a state
  bool is_loaded = true;          ///< it can be given a value on a later clock
};

/// A memory of the RTL.
struct Contents {
  std::string name;
  std::size_t low = 0, words = 0;
  std::string file;  ///< of $readmemb, with what it is given
};

struct Stimulus {
  bool steps = false;                       ///< clocks are inputs: whether their edge comes
  std::map<std::string, std::string> tied;  ///< inputs that have a value, binary
  std::vector<std::string> inputs;          ///< in the order of a row
  std::vector<std::string> rows;            ///< a line a clock, behind row 0
  std::vector<std::string> outputs;         ///< that are printed
  /// Ports that are unpacked arrays: the sizes of their dimensions, the first index first. The
  /// first element has the highest bits.
  std::map<std::string, std::vector<long>> arrays;
  std::vector<Variable> variables;  ///< that are printed behind them
  std::vector<Contents> memories;
  std::vector<std::string> states;   ///< of all variables, a line for each time they are loaded
  std::size_t first_load = 0;        ///< the clock on which they are loaded first
  std::string modules;               ///< Verilog: further modules
  std::string instances;             ///< of them; an input is in_NAME, an output out_NAME
  std::vector<std::string> wires;    ///< further outputs that they name
  std::vector<std::string> further;  ///< nets of theirs, of one bit, printed last
  std::string vcd;                   ///< a file for the wave; empty: none
  std::uint64_t first_drawn = 0;     ///< the clock it begins on
};

/// Verilog, a module of that name with the RTL as its instance cosim_dut. What names one variable
/// or memory stands on a line of its own, in `line_of` by the number of the line, from 1: where a
/// simulator does not know the name it can be left out. It writes to the file `lines` of a folder,
/// apart from what the RTL prints,
///   cosim_word WORD     the words of the memories, before they are given any
///   cosim_before WORD   of each variable, before it is given a value
///   cosim_replay WORD...  a line a clock, binary
/// and, at the end, cosim_done. The file `rows` of the folder has the rows.
std::string testbench(const Side& side, const Stimulus& stimulus, const std::string& module,
                      const std::string& folder, std::map<std::size_t, std::string>& line_of);

/// The variables of a side that are all registers. `begins` has a digit for each register of the
/// side, what it begins as, or is empty: one that has no initial value of its own is given it.
std::vector<Variable> variables_of(const Side& side, const std::string& begins);

/// Variables are loaded so often, from Stimulus::first_load on.
inline constexpr std::size_t load_clocks = 8;

/// Row 0: clocks rest, no asynchronous reset is active before the first clock, and all else is x.
std::string at_rest(const Side& side, const Stimulus& stimulus);

/// A name as Verilog has it, escaped: it may be a keyword.
std::string verilog_name(const std::string& name);

}  // namespace cosim::equiv
