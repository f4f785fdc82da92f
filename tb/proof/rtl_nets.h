// The RTL as a graph of gates, with names for its bits.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tb/nets/graph.h"
#include "tb/proof/yosys.h"
#include "tb/rtl/netlist.h"

namespace cosim::proof {

/// How SystemVerilog declares its unpacked arrays, which its netlist no longer tells.
enum class Order {
  upward,    ///< logic [7:0] held [2], held [0:1]: element 0 has the highest bits of its net
  downward,  ///< held [1:0]: it has the lowest
  several,   ///< it has several dimensions
  both       ///< one is declared so and another otherwise
};

/// One clock of a machine as gates and flip-flops.
class RtlNets {
 public:
  /// A latch of the graph.
  struct FlipFlop {
    nets::Bit now, next;
    std::optional<nets::Bit> clock{};  ///< none where each step is its edge
    bool falls = false;                ///< its edge is the falling one
    char initial = 'x';                ///< '0', '1', or 'x' where it has no initial value
  };
  /// Runs yosys on `source`. InputError where it cannot be run, or makes of the RTL something else
  /// than logic and flip-flops.
  explicit RtlNets(const Source& source);
  /// Makes gates of the top of `source` as yosys wrote it, with its memories as registers. What the
  /// RTL leaves open is free, and what an operator does is 0: a quotient by 0, what is beyond the
  /// end of a word.
  RtlNets(const netlist::Module& module, const Source& source);

  /// All that its nets and flip-flops read; each of its latches is a flip-flop.
  const nets::Graph& graph() const { return graph_; }
  const std::vector<FlipFlop>& flip_flops() const { return flip_flops_; }
  /// The inputs of the graph: those of the RTL, and what it leaves undefined.
  const nets::Bits& pins() const { return pins_; }
  const nets::Bits& undefined() const { return undefined_; }
  /// The ports of the top; of the inputs all but the clocks of its flip-flops.
  std::vector<std::string> inputs() const;
  std::vector<std::string> outputs() const;
  /// Whether the RTL asserts something, where yosys has read it.
  bool asserts() const { return asserts_; }
  /// How many bits a wire of the top has, the word "store[3]" of a memory too; 0 where there is
  /// none.
  int width(const std::string& wire) const;
  /// The number that the RTL gives the first word of a memory; 0 where there is no such memory.
  int first_word(const std::string& memory) const;
  /// Whether element 0 of an array that has become one wire has the wire's highest bits. InputError
  /// where it is declared in two ways.
  bool is_upward(const std::string& array) const;
  /// A bit of it, counted from the lowest.
  nets::Bit net(const std::string& wire, int bit) const;
  /// All bits from one on.
  nets::Bits bits(const std::string& wire, int low, int width) const;
  /// The flip-flop that a net shows, by its number. Under an asynchronous reset a net that shows a
  /// constant where the reset is given, else a flip-flop, shows that one.
  std::optional<std::size_t> shown(nets::Bit net) const;
  using Stated = std::vector<std::pair<std::string, nets::Bit>>;
  /// The nets that are 1 where what the RTL asserts is not so, where they are kept, with their
  /// assertions' names: a label, or a file and a line.
  const Stated& unmet() const { return unmet_; }
  /// The same of what the RTL covers: nets that are 1 where it holds.
  const Stated& covered() const { return covered_; }
  /// Whether such a net says so of the clock before: what is stated at a clock is sampled by
  /// flip-flops of its own, which are all that the net depends on.
  bool is_sampled(nets::Bit stated) const;
  /// The nets of a bit by its name in the RTL, "count[3]", in each instance whose path, "a.b", is
  /// one that `instance` tells of, in which "*" stands for any text. None where yosys has none.
  nets::Bits nets_in(const std::string& instance, const std::string& bit) const;

 private:
  class Maker;
  struct Wire {
    std::string way{};  ///< "input", "output", "inout" or ""
    int width = 1;
    int first = 0;           ///< the index of its lowest bit
    bool is_upward = false;  ///< declared as [0:7]: the lowest bit has the highest index

    std::string bit(const std::string& name, int i) const;
  };
  void find_flip_flops();

  std::string name_;
  bool is_reset_asynchronous_;
  nets::Graph graph_;
  nets::Bits pins_, undefined_;
  std::vector<FlipFlop> flip_flops_;
  bool asserts_ = false;
  std::optional<std::map<std::string, Order>> arrays_;  ///< of RTL that slang has read
  std::map<std::string, Wire> wires_;
  std::map<std::string, nets::Bit> named_;
  Stated unmet_, covered_;
  std::vector<std::optional<std::size_t>> shown_;  // by gate
};

/// For yosys, behind what makes one module of RTL: the command, with "; " before it, that writes it
/// into a folder.
std::string command_to_write_nets(const std::filesystem::path& folder);
/// What it wrote.
RtlNets written_nets(const std::filesystem::path& folder, const Source& source);

}  // namespace cosim::proof
