// What a process of RTL reads and writes, in the order of its statements.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tb/rtl/bit_set.h"
#include "tb/rtl/design.h"

namespace cosim::rtl {

/// Bits of nets.
using Bits = std::map<std::string, BitSet>;

/// An edge of a net.
struct EdgeOf {
  std::string way;  ///< POS, NEG or BOTH, as Verilator has it
  std::string net;
};

struct Process {
  /// What is written for sure on the way so far. A way that has been left writes anything.
  struct Sure {
    bool is_left = false;
    Bits bits = {};
  };
  const Node* body = nullptr;
  const Scope* scope = nullptr;
  std::vector<EdgeOf> edges = {};     ///< none: it is not clocked
  std::set<std::string> tested = {};  ///< the nets that it reads or writes, beside its edges
  Bits written = {}, later = {};      ///< the second by `<=`
  Sure sure = {};
  bool is_wire = false;  ///< an assignment of a net as it is
  int loops = 0;
  std::vector<Sure> jumps = {};      // of the block that it is in: what was sure where it was left
  std::set<std::string> calls = {};  // the tasks that it is in

  Bits held = {};  ///< the bits that hold a state; not empty
  std::string clock = {};
  std::vector<EdgeOf> others = {};  ///< beside its clock's
  bool is_inner = false;            ///< a register resets it
  const std::string& first_held() const { return held.begin()->first; }
};

/// A part of a net.
struct NetPart {
  const Node* reference = nullptr;
  long low = 0, bits = 0;
  bool is_exact = true;  ///< just these bits, else some of them
};

/// The parts of nets that an expression is; the other expressions in it, as indices, are put into
/// the list.
std::vector<NetPart> net_parts(const Design& design, const Node& node,
                               std::vector<const Node*>& others);

class Reads {
 public:
  explicit Reads(const Design& design) : design_(design) {}
  /// The reads and writes of a process in a statement or expression; those of a task are those in
  /// it.
  void follow(const Node& node, const Scope& scope, Process& p);
  /// All bits of the net are read, where there is one.
  void expose(const std::string& net);

  /// Bits that are read before they are written, somewhere.
  const Bits& exposed() const { return exposed_; }
  /// Whether something is worked out from the net: it is not only carried on.
  bool is_value(const std::string& net) const { return values_.contains(net); }

 private:
  void read(const std::string& net, const BitSet& bits, const Process& p);
  void write(const NetPart& part, bool is_later, const Scope& scope, Process& p);
  void choose(const Node& node, const Scope& scope, Process& p);
  void call(const Node& node, const Scope& scope, Process& p);
  void follow_all(const Node& node, const Scope& scope, Process& p);
  bool has_all_items(const Node& node) const;

  const Design& design_;
  Bits exposed_;
  std::set<std::string> values_;
};

}  // namespace cosim::rtl
