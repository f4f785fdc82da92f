// The registers, clocks and resets of a design, told from its tree.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace cosim::rtl {

struct RegistersAsked {
  std::filesystem::path tree;      ///< that Verilator wrote
  std::filesystem::path warnings;  ///< what `verilator --lint-only` said
  std::filesystem::path netlist;   ///< of yosys (netlist.h); empty: it cannot read the RTL
  /// CLOCK[,CLOCK]...[:RESET]. CLOCK is the name of an input; "-" where there is to be no register
  /// at all; "?" where the clocks are to be found: then there is no line clock where there is no
  /// register. One without a comma has registers on its rising edge alone.
  std::string clocks;
};

/// Prints a line each:
///
///   register NAME WIDTH WORDS BITS [NET WIDTH WORDS LOW]...
///                      a register, by its path below the top, its bits, those of a word of a
///                      memory, and its words, 0 where it is no memory, -1 where no table can have
///                      it; those of its bits that hold a state, "7:4,0:0", the words of a memory
///                      one behind the other; and the nets that carry its value, from bit LOW up
///   output NAME        an output
///   reset NAME         an input that resets some of them asynchronously, "low NAME" where it is
///                      low
///   inner NAME         a register that does, likewise
///   loop NAME          a net that may be in a combinational loop
///   clock NAME         a clock, "falling NAME" where registers change on that edge
///   clocked REGISTER NAME
///                      where there are several clocks, one that it changes on
///   synchronous NAME   of a clock of which none is asynchronous, the input that gives most of its
///                      registers a constant at the clock, "low NAME" likewise: RESET, or one that
///                      is called so
///   given RESET NAME HEX
///                      where there are several resets, the constant that one gives a register
///   value NAME HEX     the constant that all resets together, or where there is none an initial
///                      block, give a register; no line of one that has none
///
/// A bit holds a state where a clock writes it with <=, or with = and it is read before that on
/// some way through the process, or elsewhere. A loop is taken to write all that it writes at an
/// index that changes; yosys, where it reads the RTL, tells where that is not so. InputError, which
/// names the net, where the design has what none can have: a clock that is no input, both edges of
/// one, a latch, a port of both directions.
void print_registers(const RegistersAsked& asked, std::ostream& out);

}  // namespace cosim::rtl
