// A module as a front end of yosys writes it, as JSON and as text: the one reader of both.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace cosim::netlist {

/// The bits of a module: the number of a net, or one of these.
enum Constant : int { zero = -1, one = -2, is_x = -3, is_z = -4 };

struct Cell {
  std::string name, type;
  std::string source;                             ///< "t.v:5.3-5.9", where it is known
  std::map<std::string, std::string> parameters;  ///< numbers as binary digits
  std::map<std::string, std::vector<int>> pins;   ///< the lowest bit first
  std::vector<std::string> outputs{};             ///< the pins that it drives, or may drive

  bool has(const std::string& pin) const { return pins.contains(pin); }
  const std::string& parameter(const std::string& called) const;  ///< "0" where it has none
  bool flag(const std::string& called) const { return parameter(called).back() == '1'; }
  unsigned number(const std::string& called) const;
  bool starts_with(const char* begins) const { return type.rfind(begins, 0) == 0; }
  /// A flip-flop or a latch: what has the pin Q.
  bool is_register() const { return has("Q"); }
  bool is_memory() const { return type == "$mem_v2"; }
};

struct Net {
  std::string name;
  std::vector<int> bits;
  std::string init;       ///< binary digits, the highest first; empty where it has no initial value
  bool is_named = false;  ///< by a person, and not by yosys
  int low = 0;            ///< the index of its lowest bit, or of its highest one
  bool is_upward = false;  ///< declared as [0:7]: its highest bit has the index `low`
};

struct Port {
  std::string name;
  std::string way;       ///< "input", "output" or "inout"
  std::string declared;  ///< "signed [7:4]", as in its Verilog; nothing for a plain bit
  std::vector<int> bits;
};

struct Module {
  std::vector<Port> ports;
  std::vector<Cell> cells;
  std::vector<Net> nets;
};

/// The top of a design that `write_json` wrote. InputError where it has none, or is no JSON.
Module module_of(const std::string& json);

/// RTLIL without what says nothing of what it does: its name, where it comes from, and the names
/// that yosys made, which are numbered in the order in which they are met. Modules whose forms are
/// the same text are the same.
std::string form_of(const std::string& rtlil);

}  // namespace cosim::netlist
