// Liberty files, the descriptions of cells that come with a process: groups, and what stands in
// them.
#pragma once

#include <string>
#include <vector>

namespace cosim::cli {

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
