// The modules of a design, its types, and the nets that it has, by their paths below the top.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tb/rtl/tree.h"

namespace cosim::rtl {

struct Net {
  std::string type = {};       ///< its number
  std::string type_name = {};  ///< as the RTL has it, "" where that is not told
  long width = 1;              ///< of a word
  long words = 0;  ///< of a memory; 0: it is none; -1: no table can have it, such as a queue
  bool is_signed = false;
  long first = 0;  ///< the lowest index of a memory

  long bits() const { return width * (words > 0 ? words : 1); }
};

/// What names are in a module, a named block or a task: nets by their paths, and tasks.
struct Scope {
  std::string path;  ///< "" of the top, or "core.alu."
  const Scope* around = nullptr;
  std::map<std::string, std::string, std::less<>> nets = {};
  std::map<std::string, const Node*, std::less<>> tasks = {};
};
struct Task {
  const Node* node = nullptr;  ///< null: there is none of that name
  const Scope* home = nullptr;
};

class Design {
 public:
  /// InputError where no module is the top.
  explicit Design(const Tree& tree);

  const Node& top() const { return *top_; }
  /// Null where the tree does not have it.
  const Node* module(std::string_view name) const;
  const std::vector<const Node*>& packages() const { return packages_; }
  const std::map<std::string, const Node*, std::less<>>& types() const { return types_; }

  /// Without the names that stand for it; an empty node where there is no such type.
  const Node& type_of(const std::string& id) const;
  long size_of(const std::string& id) const;  ///< bits
  bool is_signed(const std::string& id) const;
  /// The sizes of its dimensions that are not packed, the first index first, and the type of a
  /// word.
  std::pair<std::vector<long>, std::string> unpacked(const std::string& id) const;

  /// Adds the nets in the node and below; `path` is as of Scope.
  void declare(const Node& node, const std::string& path);
  const std::map<std::string, Net, std::less<>>& nets() const { return nets_; }
  const Net* net(std::string_view path) const;
  /// A name that the tree does not have.
  void add(const std::string& path, const Net& net) { nets_.try_emplace(path, net); }
  /// A port that is an interface is the interface there.
  void alias(const std::string& port, const std::string& path) { aliases_[port] = path; }

  const Scope& scope_in(const Node& node, const std::string& path, const Scope* around) const;
  /// The tasks of a package are known everywhere.
  void publish(const Scope& package);
  Task task(const std::string& name, const Scope& scope) const;
  /// The nets that a reference may be: one, unless its name alone tells.
  std::vector<std::string> nets_of(const Node& reference, const Scope& scope) const;
  /// The first of them; "" where there is none.
  std::string net_of(const Node& reference, const Scope& scope) const;

 private:
  const Node* top_ = nullptr;
  std::map<std::string, const Node*, std::less<>> modules_, types_;
  std::vector<const Node*> packages_;
  std::map<std::string, Net, std::less<>> nets_;
  std::map<std::string, std::vector<std::string>, std::less<>> by_name_, in_packages_;
  std::map<std::string, Task, std::less<>> tasks_of_packages_;
  std::map<std::string, std::string, std::less<>> aliases_;
  mutable std::deque<Scope> scopes_;  // of all that asked
};

/// The two bounds of an array's range; none where they are no numbers.
std::vector<long> bounds_of(const Node& array);

/// The number of a node; none where it is no constant of up to 32 bits.
std::optional<long> constant(const Node* node);

}  // namespace cosim::rtl
