// What Verilator and yosys find in RTL that somebody brings: its ports, parameters and registers.
#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/core/fields.h"
#include "tb/rtl/shape.h"

namespace cosim::cli {

/// A number with the parameters' defaults.
struct FoundSize {
  int number = 1;
  std::string text = {};  ///< how it follows parameters: "{WIDTH} + 1"; empty: not
};

/// A port, a register or a memory.
struct FoundNet {
  std::string name;        ///< of a register its path below the top
  FoundSize width;         ///< bits, of a memory those of a word
  FoundSize words = {0};   ///< of a memory; 0: none; -1: of a queue and the like
  bool is_signed = false;  ///< it, or each word, is a number with a sign
  bool is_reset = true;    ///< false of a register to which no reset gives a constant
  std::string value = {};  ///< that constant, in hexadecimal; empty: 0
  /// The bits that hold a state, high and low; empty: all.
  std::vector<std::pair<int, int>> bits = {};
  std::vector<rtl::Part> parts = {};     ///< all, the highest bits first; empty: it is a number
  Edge edge = Edge::none;                ///< of an input that is one of several clocks
  std::vector<std::string> clocks = {};  ///< of a register those of several that it changes on
};

struct FoundClock {
  std::string name;
  Edge edge = Edge::rising;
};

struct FoundParameter {
  std::string name;
  std::string value;     ///< its default, or what --param gives it
  bool is_text = false;  ///< it is no number
};

/// An input, or a register, that resets registers.
struct FoundReset {
  std::string name;
  bool active_low = false;
  bool is_inner = false;  ///< a register, which resets others without waiting for the clock
  /// What it gives by itself, where there are several: registers and constants.
  std::vector<std::pair<std::string, std::string>> values = {};
};

struct Found {
  std::string top;
  std::vector<FoundClock> clocks;  ///< none where there is no register
  std::vector<FoundReset> resets;  ///< all that are asynchronous, or one that is thought to be one
  bool asynchronous = false;       ///< they reset without waiting for the clock
  std::vector<FoundNet> inputs, outputs, registers;  ///< inputs without the clock where it is one
  std::vector<FoundParameter> parameters;  ///< of the top: whole numbers that follow no other
  std::map<std::string, std::vector<std::string>> enums;  ///< the names of their values from 0 on
  std::string language;  ///< as what files .v are read, and why; "" where that is SystemVerilog
  std::string unread;    ///< why yosys, where it is installed, does not read it; "" where it does

  /// A register resets others: nothing is proved.
  bool has_inner_reset() const {
    return std::ranges::any_of(resets, [](const auto& r) { return r.is_inner; });
  }
  /// There are several, or registers change on the falling edge of the one: inputs of the model.
  bool clocks_are_inputs() const {
    return clocks.size() > 1 || (clocks.size() == 1 && clocks.front().edge == Edge::falling);
  }
};

/// Where the files are, and what is to be said of them.
struct RtlQuestion {
  std::filesystem::path folder;      ///< of all files
  std::vector<std::string> files;    ///< by their names in it, which need no quotes
  std::vector<std::string> options;  ///< -I and -D of Verilator and yosys
  std::string top;
  std::vector<std::string> clocks;         ///< pins; none: to be found
  std::string reset;                       ///< a pin; empty: to be found
  std::vector<FoundParameter> parameters;  ///< those that are given
  std::vector<std::string> blackboxes;     ///< modules whose pins become ports
};

/// Has Verilator write the tree of the files into the folder `work`, and gives its path. Of a
/// question its folder, files, options and top count. InputError, one line.
std::filesystem::path tree_in(const RtlQuestion& question, const std::filesystem::path& work);

/// Reads the files. InputError, one line, where Verilator cannot, and for what a design cannot
/// have: a clock that is no input, a latch, a bidirectional port. `said`: is told what takes long.
Found found_in(const RtlQuestion& question);

}  // namespace cosim::cli
