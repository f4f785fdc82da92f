// Ports of the top that are interfaces. No tool has one at the top: in the wrapper each member that
// the modport names is a port.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tb/rtl/tree.h"

namespace cosim::cli {

/// `interface.modport name range`, as in the head of a module.
struct InterfacePort {
  std::string interface, modport, name;
  std::string range = {};                          ///< of an array, "[N]" or "[3:0]"
  std::size_t at = 0, end = 0;                     ///< its place in the head
  std::map<std::string, std::string> values = {};  ///< of the interface's parameters
};

/// The module `name` with an instance of each, and without ports: Verilator writes the tree of
/// that.
std::string probe_of(const std::string& name, const std::vector<InterfacePort>& ports);

/// What the wrapper has of one.
struct OpenedPort {
  std::vector<std::string> ports;  ///< with their directions and types
  std::string body;                ///< the instance, and what joins its members and the ports
};

/// `tree`: of the probe; `pins`: the other ports of the top, of which the interface's own ports get
/// those of their names. InputError, one line, for what cannot be a port.
OpenedPort opened(const InterfacePort& port, const rtl::Tree& tree,
                  const std::set<std::string>& pins);

}  // namespace cosim::cli
