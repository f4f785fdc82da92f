// RTL as Verilog that every tool reads.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tb/rtl/run.h"

namespace cosim::rtl {

struct Sources {
  std::filesystem::path folder = ".";  ///< the files are named as from here
  std::vector<std::string> files = {};
  std::string top = {};
  std::vector<std::string> parameters = {};  ///< "NAME=VALUE"
  std::vector<std::string> blackboxes = {};  ///< modules that no file has
  /// Constants that an instance of a blackbox is given are outputs too: at pins, parameters
  /// (u$parameter$NAME) and attributes (u$attribute$NAME). Of the pins on a net that nothing is
  /// known to drive the first one drives it.
  bool has_constants = false;
};

/// Has an instance `u` of a blackbox NAME as ports: u$PIN is an input of the top for an output of
/// NAME, and an output for an input. An instance that lies deeper has its path before it:
/// core$u$PIN. A file may have a module NAME, whose body is not read, for the directions; without
/// it a pin is an output if nothing else drives its net. Writes files that change into the folder
/// `to`, line by line as they were. All files to read; InputError, as below, where it cannot be
/// done.
std::vector<std::string> without_blackboxes(const Sources& sources,
                                            const std::filesystem::path& to);

/// Has three ports for an inout port `pad` that is driven `en ? value : 'z`: pad$in, which comes
/// from outside, pad$out, and pad$en, the bits that are driven. In the module the net `pad` has the
/// value on the wire. An inout port that nothing drives becomes an input. A port is driven by an
/// assignment, bufif0, bufif1 or a module whose port is split. The files are as of
/// without_blackboxes().
std::vector<std::string> with_split_inouts(const Sources& sources, const std::filesystem::path& to);

bool is_vhdl(const std::filesystem::path& file);

/// Does both, with one file of Verilog in place of those of VHDL (vhdl.h): writes vhdl.v and the
/// folders ghdl, blackbox and inout into the folder `to`.
std::vector<std::string> plain_verilog(Sources sources, const std::filesystem::path& to,
                                       const Run& run);
/// The VHDL that the file `made`, one that plain_verilog() named, was made of; empty for another
/// file, and where the design has Verilog, too.
std::vector<std::filesystem::path> vhdl_of(const std::filesystem::path& made);

}  // namespace cosim::rtl
