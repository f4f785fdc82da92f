// One of two RTLs that are compared, as gates and registers.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/core/input_error.h"
#include "tb/nets/graph.h"
#include "tb/rtl/netlist.h"
#include "tb/util/process.h"

namespace cosim::equiv {

using netlist::Cell;
using netlist::Module;
using netlist::Net;
using netlist::Port;
using enum netlist::Constant;
using nets::Bit;
using nets::Bits;
using nets::Graph;
using nets::no;
using nets::yes;

struct OutOfTime {};

/// RTL that no netlist can stand for, whoever reads it.
struct Refused : InputError {
  using InputError::InputError;
};

/// How much time is left for a question, by the clock on the wall.
class Budget {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Budget(int seconds)
      : began_(Clock::now()), ends_(began_ + std::chrono::seconds(seconds)) {}
  Clock::duration spent() const { return Clock::now() - began_; }
  /// When it is over.
  Clock::time_point ends() const { return ends_; }
  /// OutOfTime where none is left.
  void check() const {
    if (Clock::now() >= ends_) throw OutOfTime();
  }

 private:
  Clock::time_point began_, ends_;
};

/// Verilog as a person names it.
struct Files {
  std::vector<std::filesystem::path> files;
  std::string top;
  std::vector<std::string> parameters;  ///< "NAME=VALUE", as Verilog writes the value
  std::vector<std::filesystem::path> include_dirs;
  std::vector<std::string> defines;    ///< "NAME" or "NAME=VALUE"
  std::filesystem::path folder = ".";  ///< from which $readmemh finds its files
  /// The VHDL that all of `files` was made of; empty where it is not so.
  std::vector<std::filesystem::path> vhdl{};
};

/// A bit of a port, a net or a register: its hierarchical name, and which bit.
using Name = std::pair<std::string, int>;

struct Register {
  Name name;            ///< empty where the RTL has none
  bool any = false;     ///< it has no initial value
  bool first = false;   ///< what it is, if it has one
  std::set<Name> nets;  ///< all that it drives directly; `name` is one of them, if there is one
};

struct Memory {
  std::string name;
  std::string shape;           ///< equal texts: the same words, reads and initial contents
  bool any = false;            ///< some of it has no initial value
  int width = 0, address = 0;  ///< bits of a word and of an address
  int reads = 0, writes = 0;   ///< ports
  std::string clock{};         ///< that writes it, an input; empty where none does
};

/// What is made of memories.
enum class Memories {
  /// What they read are inputs, what goes to them are outputs, as named by memory_port().
  cut,
  registers,
};
/// "RD_DATA", "RD_ADDR", "WR_EN", "WR_ADDR" or "WR_DATA" of one of Side::memories; of several
/// ports the bits stand side by side, an enable for each bit of a word.
std::string memory_port(std::size_t memory, const char* port);

/// What reads Verilog.
enum class FrontEnd {
  yosys,  ///< read_verilog of the yosys that is installed
  slang,  ///< read_slang of another one (front_end.h)
};
const char* name_of(FrontEnd front_end);

class Side {
 public:
  /// Reads the files: ports, clock and memories. InputError, one line that begins with `what` or a
  /// file, where the front end cannot, and for a clock of which both edges are taken or that is no
  /// input, a latch, a bidirectional port, or a net with several drivers. OutOfTime.
  Side(const Files& files, std::string what, FrontEnd front_end, const Budget& budget);
  /// Makes gates of it, by which all else is known. A register that takes over at once what an
  /// asynchronous reset gives is one of the clock and a multiplexer. With `steps` a clock is an
  /// input that says whether it takes its edge, and a register holds what it has where its clock
  /// does not. InputError for a combinational loop or a cell that is not known. OutOfTime.
  void make_gates(Memories memories, bool steps, const Budget& budget);
  /// A register that drives a net whose name another side's register drives too gets the name of
  /// that one: synthesis makes new names for a register's net, and keeps the old ones beside them.
  void name_as(const Side& other);
  /// The registers on these nets count their bits by the indices of the declaration, [31:2] from 2.
  void number_as_declared(const std::set<std::string>& nets);

  const Files& files() const { return files_; }
  const std::string& what() const { return what_; }
  FrontEnd front_end() const { return front_end_; }
  const Module& module() const { return *module_; }
  /// "variable k of function f may keep its value from call to call": it is read where no call has
  /// written it, unless that way through the function is never taken. Empty where there is none.
  std::string kept_by_function() const;
  /// Whether an incomplete `unique case` is any value in it.
  bool has_unique() const { return has_unique_; }
  /// Whether a register may begin as 0 for its type's sake, where Icarus Verilog has an x.
  bool has_zeros_by_type() const { return has_zeros_by_type_; }
  /// Whether its memories were cut when its gates were made.
  bool is_cut() const { return is_cut_; }
  /// Equal where the RTLs are the same but for where it stands in the files.
  const std::string& form() const { return form_; }
  std::map<std::string, int> inputs, outputs;   ///< ports and their widths
  std::map<std::string, std::string> declared;  ///< of ports: "signed [7:4]", as in their Verilog
  std::map<std::string, bool> clocks;    ///< inputs; true: its registers take over when it falls
  std::set<std::string> clocks_as_data;  ///< those that are read by more than registers
  std::map<std::string, bool> asynchronous_resets;  ///< inputs, and the level
  std::vector<Memory> memories;
  std::vector<Register> registers;
  /// Variables of the source that are registers alone: which ones, the lowest bit first.
  std::vector<std::pair<std::string, std::vector<std::size_t>>> variables;
  std::size_t unknowns = 0;  ///< bits that the RTL leaves x

  struct Made {
    std::map<Name, Bit> outputs;
    Bits next;  ///< of the registers
    /// What the registers are seen as: another value than they hold where an asynchronous reset is.
    Bits seen;
  };
  /// Its gates in `graph`; what the inputs, the unknown bits and the registers are is given.
  Made make(Graph& graph, const std::function<Bit(const Name&)>& input, const Bits& unknown,
            const Bits& state) const;

 private:
  class Builder;
  /// An input of the gates.
  struct Source {
    enum class Kind { port, unknown, state } kind = Kind::port;
    Name name;               ///< of a port
    std::size_t number = 0;  ///< of the others
  };
  std::string kept_by_function(const Cell& cell) const;
  void ports();
  void takes_over(const std::string& clock, bool falls);

  Files files_;
  std::string what_;
  FrontEnd front_end_;
  std::shared_ptr<const Module> module_;
  std::string form_;
  bool is_cut_ = false, has_zeros_by_type_ = false, has_unique_ = false;

  Graph logic_;
  std::vector<Source> sources_;  ///< by input of `logic_`
  std::map<Name, Bit> outputs_;
  Bits next_, seen_;
};

/// Reads the files with yosys or, where it cannot and slang is there, with slang. Throws as Side's
/// constructor does, what yosys says.
Side read(const Files& files, const std::string& what, const Budget& budget);

}  // namespace cosim::equiv
