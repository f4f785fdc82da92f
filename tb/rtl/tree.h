// The tree of a design as Verilator writes it: XML or, from 5.046 on, JSON. All that depends on the
// version of these formats is in tree.cpp.
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tb/rtl/run.h"

namespace cosim::rtl {

/// A node has its tag, its attributes and the nodes in it, in the words of the XML.
struct Node {
  std::string tag;
  std::map<std::string, std::string, std::less<>> attributes;
  std::vector<Node*> in;

  /// "" where it has none of that name.
  const std::string& has(std::string_view name) const;
  bool is(std::string_view name) const { return tag == name; }
  bool is_reference() const { return tag == "varref" || tag == "varxref"; }
  /// A variable that is a port of a module or a task.
  bool is_port() const { return tag == "var" && !has("dir").empty(); }
};

/// All nodes with that tag in it and below, in their order.
std::vector<const Node*> all_of(const Node& node, std::string_view tag);

/// The words with which that Verilator writes its tree into the file that follows them.
std::vector<std::string> tree_options(const std::string& verilator, const Run& run);

class Tree {
 public:
  /// InputError where the file is no tree of Verilator.
  explicit Tree(const std::filesystem::path& file);
  const Node& root() const { return nodes_.front(); }

 private:
  class Json;
  Node* add(std::string tag);
  void read_xml(std::string_view text);

  std::deque<Node> nodes_;
};

}  // namespace cosim::rtl
