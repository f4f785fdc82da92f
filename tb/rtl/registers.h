// The registers, clocks and resets of a design, told from its tree.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cosim::rtl {

/// A bit holds a state where a clock writes it with <=, or with = and it is read before that on
/// some way through the process, or elsewhere. A loop is taken to write all that it writes at an
/// index that changes; yosys, where it reads the RTL, tells where that is not so.
struct Register {
  /// A net that has the register's value from bit `low` up.
  struct Carrier {
    std::string net;
    long width = 0, words = 0, low = 0;
  };
  std::string name;  ///< its path below the top
  long width = 0;    ///< bits, of a memory those of a word
  long words = 0;    ///< 0 where it is no memory, -1 where no table can have it
  /// The bits that hold a state, high and low, the words of a memory one behind the other.
  std::vector<std::pair<int, int>> bits = {};
  std::vector<Carrier> carriers = {};
  std::vector<std::string> clocks = {};  ///< those of several that it changes on
  /// The constant that all resets together, or where there is none an initial block, give it, in
  /// hexadecimal.
  std::optional<std::string> value = {};
};

struct Reset {
  enum class Kind {
    asynchronous,  ///< an input
    inner,         ///< a register, which resets others without waiting for the clock
    /// The input that gives most registers of a clock, of which none is reset asynchronously, a
    /// constant at the clock: the one that is asked for, or one that is called so.
    synchronous
  };
  std::string name;
  bool is_active_low = false;
  Kind kind = Kind::asynchronous;
  /// What it gives by itself, where there are several: registers and constants.
  std::vector<std::pair<std::string, std::string>> values = {};
};

struct Clock {
  std::string name;
  bool falls = false;  ///< registers change on its falling edge
};

struct Registers {
  std::vector<Register> registers;
  std::vector<Reset> resets;
  std::vector<Clock> clocks;
  std::vector<std::string> outputs;
  std::vector<std::string> loops;  ///< nets that may be in a combinational loop
};

struct RegistersAsked {
  std::filesystem::path tree;     ///< that Verilator wrote
  std::string warnings;           ///< what `verilator --lint-only` said
  std::filesystem::path netlist;  ///< of yosys (netlist.h); empty: it cannot read the RTL
  /// CLOCK[,CLOCK]...[:RESET]. CLOCK is the name of an input; "-" where there is to be no register
  /// at all; "?" where the clocks are to be found: then there is no clock where there is no
  /// register. One without a comma has registers on its rising edge alone.
  std::string clocks;
};

/// InputError, which names the net, where the design has what none can have: a clock that is no
/// input, both edges of one, a latch, a port of both directions.
Registers registers_in(const RegistersAsked& asked);

}  // namespace cosim::rtl
