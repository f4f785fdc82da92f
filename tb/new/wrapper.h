// A module around the top that gives it what no command line of a tool can: parameters that are
// types or constants such as a struct, and ports that are interfaces.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tb/new/interface_ports.h"
#include "tb/rtl/verilog.h"

namespace cosim::cli {

/// The head of a module of SystemVerilog, whose list of ports has their types.
class TopHead {
 public:
  /// `text`: of a file that has the module `top`.
  TopHead(std::string_view text, const std::string& top);

  bool has(const std::string& parameter) const { return items_.contains(parameter); }
  bool is_type(const std::string& parameter) const { return types_.contains(parameter); }

  const std::vector<InterfacePort>& interfaces() const { return interfaces_; }
  /// The names of its other ports.
  const std::set<std::string>& pins() const { return pins_; }

  /// The module `name`, with the ports and the parameters of the top and `values` as defaults of
  /// those that it names, around an instance `dut` of the top; `opened`: what it has of each
  /// interface. InputError for a parameter that the top lacks, and where its head cannot be read.
  std::string wrapped(const std::string& name, const std::map<std::string, std::string>& values,
                      const std::vector<OpenedPort>& opened) const;

 private:
  struct Item {
    std::size_t value = 0, end = 0;  ///< from the sign before its default, or its end, to its end
  };

  void read(std::string_view text);
  void read_ports(const std::vector<rtl::Piece>& items);

  std::string top_, text_;  // from behind the name to the semicolon
  std::string wrong_;       // why it cannot be read
  std::map<std::string, Item> items_;
  std::set<std::string> types_, pins_;
  std::vector<InterfacePort> interfaces_;
};

}  // namespace cosim::cli
