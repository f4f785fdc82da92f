// RTL as yosys is given it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "model/core/fields.h"
#include "tb/nets/machine.h"

namespace cosim::proof {

/// A machine in Verilog.
struct Source {
  std::vector<std::filesystem::path> files;
  std::string top;
  std::vector<Parameter> parameters;  ///< none where the files hold them
  /// Registers that stay although nothing reads them, by their nets; those named *_q stay always.
  std::vector<std::string> kept = {};
  std::vector<std::filesystem::path> include_dirs = {};
  std::vector<std::string> defines = {};  ///< "NAME" or "NAME=VALUE"
  /// Parameters that Verilog writes otherwise than as a plain number, as it does.
  std::map<std::string, std::string> constants = {};
  /// Plain Verilog of the same, with its parameters, that yosys reads in place of the files, which
  /// it cannot read; empty: none is needed.
  std::filesystem::path written = {};
  /// A register's net may be the register and, where the reset is given, a constant.
  bool asynchronous_reset = false;
  /// It has several clocks, inputs that say whether they take their edge.
  bool clocks_are_inputs = false;
  /// RtlNets keeps what the RTL asserts and covers. What is so stated at a clock takes flip-flops
  /// of its own.
  bool keeps_statements = false;
};

/// RTL as it is read for a machine: the nets of its registers are kept, and its clocks and its
/// reset are as the machine has them.
Source read_for(const nets::Machine& machine, Source source);

/// The RTL of `design`: the files of folder/design, or of the folder itself where there is no such
/// folder in it. InputError where there are none.
Source source_in(const std::filesystem::path& folder, const std::string& design,
                 const std::vector<Parameter>& parameters);

/// The commands of yosys that read the files of `source`, each by its kind: a file .sv is
/// SystemVerilog. They end in "; ".
std::string read_commands(const Source& source);
/// The same, and the one that makes its hierarchy with its parameters; they end in nothing.
std::string commands_to_elaborate(const Source& source);

/// The same, and those that make one module of it, in which a memory is a register a word,
/// store[3], and a register that nothing reads stays one.
std::string flat_commands(const Source& source);

/// Selects, for yosys, the nets of that name, and the words of a memory of that name which yosys
/// has made registers.
std::string kept_net(const std::string& name);

/// Runs yosys. InputError where there is none or it stops with an error; it names `what`.
void run_yosys(const std::string& commands, const std::string& what);

}  // namespace cosim::proof
