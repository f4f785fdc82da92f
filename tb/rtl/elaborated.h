// A design with all instances of its modules: its processes, what carries what, and its ports.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tb/rtl/carried.h"
#include "tb/rtl/design.h"
#include "tb/rtl/process.h"

namespace cosim::rtl {

class Elaborated {
 public:
  /// InputError where a port has both directions.
  explicit Elaborated(const Tree& tree);

  Design design;
  Carried carried;
  Reads reads{design};
  std::vector<Process> clocked, initial;
  std::set<std::string> inputs, outputs;
  std::vector<std::string> outputs_in_order;
  std::map<std::string, Carried::Reach> reached;  ///< of inputs, and of registers that reset others

  /// The input that a net is, or whose inverse it is; "" where it is made of something else.
  std::string input_of(const std::string& net, bool is_inverse) const;
  bool is_carried_to_output(const std::string& net) const;

 private:
  void walk(const Node& node, const std::string& path, const Scope* around);
  void assign(const Node& node, const Scope& scope);
  void add_process(const Node& node, const Scope& scope);
  void connect(const Node& port, const std::string& inner, const Scope& scope);
  void invert(const Node& value, const std::string& to, const Scope& scope);
};

}  // namespace cosim::rtl
