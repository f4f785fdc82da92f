// The gates of a side, run 64 times side by side, with its memories.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tb/equiv/side.h"
#include "tb/nets/runs.h"
#include "tb/util/random.h"

namespace cosim::equiv {

class Stepped {
 public:
  /// A bit in each run.
  using Values = std::uint64_t;

  /// `cut`: its memories were cut, and are held here. `steps`: clocks are inputs. What is not known
  /// is another value in each run and on each clock: 0 in the first, 1 in the second, and chance in
  /// the others.
  Stepped(const Side& side, bool cut, bool steps);

  /// What a register begins as, in all runs: '0' or '1', else another value in each.
  void begin(std::size_t reg, char digit);
  /// All runs begin alike, so that only what the logic itself leaves open differs in them: what has
  /// no initial value is 0 in all for `fill` 0, 1 for 1, and chance for others.
  void begin_alike(unsigned fill);
  /// The words of a memory: digits, the lowest bit first.
  void begin_memory(std::size_t memory, const std::string& digits);
  /// The values with these inputs, binary digits by port, highest bit first; no clock comes yet.
  void settle(const std::map<std::string, std::string>& inputs);
  /// A clock with these inputs, and the values on it.
  void clock(const std::map<std::string, std::string>& inputs);

  /// '0' or '1' where all runs have it, else 'x'.
  static char digit(Values bits) { return bits == 0 ? '0' : bits == ~Values{0} ? '1' : 'x'; }

  Values output(const Name& name) const { return runs_.of(made_.outputs.at(name)); }
  Values seen(std::size_t reg) const { return runs_.of(made_.seen[reg]); }
  /// What a bit of its graph is, and which inputs of that are ports and registers.
  Values of(Bit bit) const { return runs_.of(bit); }
  const Graph& graph() const { return graph_; }
  const std::map<Name, std::size_t>& ports() const { return ports_; }
  const std::vector<std::size_t>& states() const { return states_; }

 private:
  struct Held {
    std::size_t width = 0, address = 0, words = 0, low = 0, reads = 0, writes = 0;
    std::string first;  ///< digits, the lowest bit first
    std::vector<Values> bits;
    std::vector<std::size_t> read_data;  ///< inputs of the graph
    Bits read_address, enable, write_address, data;
  };
  /// A word address in each run.
  using Addresses = std::array<std::size_t, 64>;
  Values unknown();
  bool read(std::size_t memory);
  void write(std::size_t memory);
  Addresses addresses(const Bits& pins, const Held& held, std::size_t port) const;

  const Side& side_;
  bool cut_, steps_;
  Graph graph_;
  std::map<Name, std::size_t> ports_;
  std::vector<std::size_t> unknowns_, states_;
  Side::Made made_;  // behind what it is made with
  std::vector<Held> memories_;
  std::vector<Values> inputs_, next_;
  nets::Runs runs_;
  Random random_;
};

}  // namespace cosim::equiv
