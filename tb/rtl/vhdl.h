// VHDL as Verilog, by GHDL.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "tb/rtl/plain_verilog.h"

namespace cosim::rtl {

/// The entity `top` of the files with these parameters as its generics; every entity that no other
/// has an instance of where a Verilog module is the top. The module has parameters of the names of
/// the generics, whose values are those that it was made with. A register has the name of its
/// signal or of the output that it is; one that is a part of it has its place as well, q_3_0. `run`
/// runs a program and gives its status; `work` is a folder for it, which is made anew. InputError
/// with the place in the VHDL where there is no GHDL, or it cannot do it.
std::string verilog_of_vhdl(const Sources& sources, const std::filesystem::path& work,
                            const Run& run);

/// VHDL with functions of numeric_std that GHDL 2.0 synthesizes as something else.
extern const std::string_view numeric_vhd;

/// What GHDL's netlist as VHDL has of a module, and its Verilog lacks; values are those of Verilog.
struct NetlistModule {
  std::map<std::string, std::string> defaults;  ///< of a case, by the net that it drives
  std::map<std::string, std::string> initial;   ///< of a register
  std::map<std::string, std::string> edges;     ///< "posedge clk", by the net that is this edge
};
/// By the names of the modules, in small letters.
std::map<std::string, NetlistModule> netlist_modules(const std::string& vhdl);

/// InputError where GHDL gives a signal no value that has one: a register that only its reset
/// writes, which is x in its Verilog, and bits that have their initial value alone. `said`: the
/// warnings of GHDL, for a signal that truly has none.
void refuse_lost_values(const std::string& verilog, const std::string& said);

/// InputError "FILE:LINE: ..." for VHDL, without its comments, that GHDL converts to another design
/// without a word: case? with a - in a choice, and a comparison with a value that is neither 0
/// nor 1.
void refuse_misread_vhdl(const std::string& file, const std::string& text);

/// A module as GHDL 2.0 wrote it, with what its printer of Verilog gets wrong put right. InputError
/// where it cannot be. `has_any`: the VHDL has a '-', so that a choice without a value is an x.
std::string repaired(std::string module, const NetlistModule& netlist, bool has_any);

/// A module of GHDL's with registers by such names in place of n49_q.
std::string with_names(std::string module);

std::string in_small_letters(std::string text);

/// The types of VHDL texts whose values are numbers or names, in small letters.
std::set<std::string> scalar_types(const std::vector<std::string>& texts);

/// A text of VHDL in which each signal and output of such a type that has no default has the first
/// value of its type, with which it begins: GHDL would write a register without an initial value.
std::string with_first_values(const std::string& text, const std::set<std::string>& scalars);

}  // namespace cosim::rtl
