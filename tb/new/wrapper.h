// A module around the top that gives it parameters which no command line of a tool can: types, and
// constants such as a struct.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace cosim::cli {

/// The head of a module of SystemVerilog, whose list of ports has their types.
class TopHead {
 public:
  /// `text`: of a file that has the module `top`.
  TopHead(std::string_view text, const std::string& top);

  bool has(const std::string& parameter) const { return items_.contains(parameter); }
  bool is_type(const std::string& parameter) const { return types_.contains(parameter); }

  /// The module `name`, with the ports and the parameters of the top and `values` as defaults of
  /// those that it names, around an instance `dut` of the top. InputError for a parameter that the
  /// top lacks, and where its head cannot be read.
  std::string wrapped(const std::string& name,
                      const std::map<std::string, std::string>& values) const;

 private:
  struct Item {
    std::size_t value = 0, end = 0;  ///< from the sign before its default, or its end, to its end
  };

  void read(std::string_view text);

  std::string top_, text_;  // from behind the name to the semicolon
  std::string wrong_;       // why it cannot be read
  std::map<std::string, Item> items_;
  std::set<std::string> types_;
};

}  // namespace cosim::cli
