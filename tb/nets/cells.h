// The cells of a module as an and-inverter graph. This is the one place that decides what they do,
// and what is x: a bit that no cell drives, an x of the source, a quotient by 0, what is read
// beyond the end of a word or a memory, and a comparison with an x by == or != are each a value
// that is not known. A comparison with an x by === or in a `case` is false, for no net is x.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tb/nets/graph.h"
#include "tb/rtl/netlist.h"

namespace cosim::nets {

using netlist::Cell;
using netlist::Module;

class CellGates {
 public:
  /// `unknown` makes a value that is not known; it is called in the same order for the same module.
  /// With `beyond` that one makes what an operator leaves open: a quotient by 0, and what is beyond
  /// the end of a word.
  CellGates(const Module& module, Graph& graph, std::function<Bit()> unknown,
            std::function<Bit()> beyond = {});

  /// What a net is, from elsewhere: an input of the module, what a memory reads.
  void set(int bit, Bit is) { value_[bit] = is; }
  /// What a register holds; `bit` is that of its pin Q.
  void hold(int bit, Bit is) { held_[bit] = is; }
  /// The words of a memory, from that of its lowest address on.
  void hold(const Cell& memory, std::vector<Bits> words) { memories_[&memory] = std::move(words); }
  /// InputError where a cell is one that is not known, and for a combinational loop; the text says
  /// which cell, and where in the source.
  Bit of(int bit);
  Bits of(const std::vector<int>& bits);
  /// What a register holds after the edge of its clock, bit by bit of Q. With `steps` it does so
  /// where its clock is 1, and else what it had.
  Bits next(const Cell& cell, bool steps);

 private:
  struct Place {
    const Cell* cell = nullptr;
    std::size_t bit = 0;
  };
  Bit leaf(int bit);
  bool is_known(int bit) const { return bit < 0 || value_.contains(bit); }
  std::vector<int> needs(const Place& place) const;
  void evaluate(const Place& place);
  void read(const Cell& memory, std::size_t port);
  Bits words_of_memory(const Cell& memory, const Bits& address);
  Bits result(const Cell& cell);
  Bit one_bit(const Place& place);
  Bit asynchronous(const Cell& cell, std::size_t bit, Bit otherwise);
  Bits word(const Cell& cell, const char* pin);
  Bits operand(const Cell& cell, const char* pin, std::size_t width);
  Bits unknown_word(std::size_t width);
  Bits shifted(const Cell& cell, std::size_t width);
  Bits quotient(const Cell& cell, std::size_t width);
  Bits power(const Cell& cell, std::size_t width);
  Bit compared(const Cell& cell);
  Bit case_equal(const Cell& cell);
  Bits selected(const Cell& cell, std::size_t width);
  Bit any(const Bits& a);
  [[noreturn]] static void refuse(const Cell& cell, const std::string& why);

  Graph& graph_;
  std::function<Bit()> unknown_, beyond_;
  std::unordered_map<int, Place> driver_;
  std::unordered_map<int, Bit> value_, held_;
  std::unordered_map<const Cell*, std::vector<Bits>> memories_;
};

/// Connects each clock pin to the input that it is, where only constants, buffers and inverters
/// stand between them; an inverted one gets the other polarity. Others stay as they are.
void connect_clocks(Module& module);

/// A cell that is no part of what a module does: an assertion, a text that is printed.
bool is_no_logic(const Cell& cell);

}  // namespace cosim::nets
