// What a text of Verilog or VHDL declares and uses, told from its words: no parser, for it is only
// to find the files that a parser is to read.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace cosim::cli {

struct VerilogUnit {
  std::string name;
  bool is_package = false;
  bool is_module = false;  ///< not an interface, a package or a program
  bool has_ports = false;
  /// Words that stand where the name of a module, an interface or a package may.
  std::set<std::string> uses = {};
};

/// One without ports.
inline bool is_testbench(const VerilogUnit& unit) { return unit.is_module && !unit.has_ports; }

struct VerilogText {
  std::vector<VerilogUnit> units;  ///< the first has no name: what stands outside of any
  std::vector<std::string> headers;
  std::vector<std::string> data;  ///< files of $readmemh and $readmemb
};

VerilogText verilog_words(std::string_view text);
/// The same of VHDL: an entity is a module. Names are in small letters.
VerilogText vhdl_words(std::string_view text);

}  // namespace cosim::cli
