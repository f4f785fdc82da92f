// The cells of a Liberty file in Verilog.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace cosim::cli {

/// By its name, *.lib.
bool is_liberty(const std::string& file);

struct LibertyCells {
  std::string verilog;                          ///< a module a cell
  std::map<std::string, std::string> left_out;  ///< cells of which none can be made, and why
};

/// `text` is that of `file`. InputError "FILE:LINE: ...".
LibertyCells cells_of(const std::string& text, const std::string& file);

struct LibertyGroup {
  std::string kind;                ///< "cell"
  std::vector<std::string> names;  ///< what stands in its parentheses
  struct Attribute {
    std::string name, value;
  };
  std::vector<Attribute> attributes;  ///< NAME : VALUE;
  std::vector<LibertyGroup> groups;

  /// The value of an attribute; "" where it has none.
  std::string value(const std::string& name) const;
  std::string name() const { return names.empty() ? "" : names.front(); }
};

/// The library. InputError "FILE:LINE: ..." where it is none, or includes another file.
LibertyGroup read_liberty(const std::string& text, const std::string& file);

}  // namespace cosim::cli
