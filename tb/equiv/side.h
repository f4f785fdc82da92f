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

#include "tb/proof/aig.h"
#include "tb/support/process.h"

namespace cosim::equiv {

struct OutOfTime {};

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

class Side {
 public:
  /// Reads the files with yosys: ports, clock and memories. InputError, one line that begins with
  /// `what` or a file, where yosys cannot, and for a clock of which both edges are taken or that is
  /// no input, a latch, a bidirectional port or a combinational loop. OutOfTime.
  Side(const Files& files, std::string what, const Budget& budget);
  /// Makes gates of it, by which all else is known. A register that takes over at once what an
  /// asynchronous reset gives is one of the clock and a multiplexer. With `steps` a clock is an
  /// input that says whether it takes its edge, and a register holds what it has where its clock
  /// does not. InputError and OutOfTime.
  void make_gates(Memories memories, bool steps, const Budget& budget);
  /// A register that drives a net whose name another side's register drives too gets the name of
  /// that one: synthesis makes new names for a register's net, and keeps the old ones beside them.
  void name_as(const Side& other);

  const Files& files() const { return files_; }
  /// Equal where the RTLs are the same but for where it stands in the files.
  std::string form() const;
  std::map<std::string, int> inputs, outputs;   ///< ports and their widths
  std::map<std::string, std::string> declared;  ///< of ports: "signed [7:4]", as in their Verilog
  std::map<std::string, bool> clocks;    ///< inputs; true: its registers take over when it falls
  std::set<std::string> clocks_as_data;  ///< those that are read by more than registers
  std::map<std::string, bool> asynchronous_resets;  ///< inputs, and the level
  bool sets_and_resets = false;  ///< a register has an asynchronous set and a reset
  std::vector<Memory> memories;
  std::vector<Register> registers;
  std::size_t unknowns = 0;  ///< bits that the RTL leaves x

  struct Made {
    std::map<Name, proof::Aig::Lit> outputs;
    std::vector<proof::Aig::Lit> next;  ///< of the registers
  };
  /// Its gates in `graph`; what the inputs, the unknown bits and the registers are is given.
  Made make(proof::Aig& graph, const std::function<proof::Aig::Lit(const Name&)>& input,
            const std::vector<proof::Aig::Lit>& unknown,
            const std::vector<proof::Aig::Lit>& state) const;

 private:
  struct Gate {
    unsigned out, a, b;
  };
  std::string yosys(const std::string& script, const Budget& budget) const;
  void read(const std::string& aiger, const std::string& map);
  void ports(const std::string& json);
  void takes_over(const std::string& clock, bool falls);

  Files files_;
  std::string what_;
  std::shared_ptr<const Scratch> scratch_;

  std::vector<unsigned> in_, state_, next_, out_;
  std::vector<Gate> gates_;
  std::map<std::size_t, Name> in_names_;
  std::multimap<std::size_t, Name> out_names_;  ///< several may be the same gate
};

}  // namespace cosim::equiv
