// What a design's RTL is, before anything is built from it: Verilator and yosys are asked.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tb/rtl/registers.h"
#include "tb/rtl/run.h"

namespace cosim::rtl {

struct RtlAsked {
  std::string verilator;               ///< the program
  std::string yosys;                   ///< the program; empty: there is none
  std::filesystem::path folder = ".";  ///< the files are named as from here
  std::vector<std::string> files;
  std::vector<std::string> options;  ///< of Verilator: -I, -D and -G
  std::string top;
  std::string clocks;          ///< as of RegistersAsked
  std::filesystem::path work;  ///< a folder for this alone
};

struct RtlRead {
  Registers found;
  std::vector<std::string> sources;    ///< files that were read, headers too
  std::vector<std::string> verilator;  ///< options without which Verilator cannot build it
  std::string language;  ///< as what files .v are read, and why; empty: as SystemVerilog
  std::string unread;    ///< why yosys, if there is one, does not read it; empty: it does
  std::string doubt;     ///< a net that may be in a loop, which yosys could tell; empty: none
};

/// Writes the tree (tree.h) of RTL, and gives its path. Of what is asked the netlist does not
/// count. InputError, one line, where Verilator cannot read it.
std::filesystem::path write_tree(const RtlAsked& asked, const Run& run);

/// Writes the tree to WORK/tree, and to WORK/plain.sv the preprocessed text. InputError,
/// one line, where Verilator cannot read it, and for what no design can have (registers.h), a
/// combinational loop too.
RtlRead read_rtl(const RtlAsked& asked, const Run& run);

}  // namespace cosim::rtl
