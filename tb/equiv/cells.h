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

#include "tb/equiv/arithmetic.h"
#include "tb/equiv/netlist.h"
#include "tb/proof/aig.h"

namespace cosim::equiv {

class Cells {
 public:
  using Lit = proof::Aig::Lit;

  /// `unknown` makes a value that is not known; it is called in the same order for the same module.
  Cells(const Module& module, proof::Aig& graph, std::function<Lit()> unknown);

  /// What a net is, from elsewhere: an input of the module, what a memory reads.
  void set(int bit, Lit is) { value_[bit] = is; }
  /// What a register holds; `bit` is that of its pin Q.
  void hold(int bit, Lit is) { held_[bit] = is; }
  /// The words of a memory, from that of its lowest address on.
  void hold(const Cell& memory, std::vector<Lits> words) { memories_[&memory] = std::move(words); }
  /// InputError where a cell is one that is not known, and for a combinational loop; the text says
  /// which cell, and where in the source.
  Lit of(int bit);
  Lits of(const std::vector<int>& bits);
  /// What a register holds after the edge of its clock, bit by bit of Q. With `steps` it does so
  /// where its clock is 1, and else what it had.
  Lits next(const Cell& cell, bool steps);

 private:
  struct Place {
    const Cell* cell = nullptr;
    std::size_t bit = 0;
  };
  Lit leaf(int bit);
  bool is_known(int bit) const { return bit < 0 || value_.contains(bit); }
  std::vector<int> needs(const Place& place) const;
  void evaluate(const Place& place);
  void read(const Cell& memory, std::size_t port);
  Lits words_of_memory(const Cell& memory, const Lits& address);
  Lits result(const Cell& cell);
  Lit one_bit(const Place& place);
  Lit asynchronous(const Cell& cell, std::size_t bit, Lit otherwise);
  Lits word(const Cell& cell, const char* pin);
  Lits operand(const Cell& cell, const char* pin, std::size_t width);
  Lits unknown_word(std::size_t width);
  Lits shifted(const Cell& cell, std::size_t width);
  Lits quotient(const Cell& cell, std::size_t width);
  Lits power(const Cell& cell, std::size_t width);
  Lit compared(const Cell& cell);
  Lit case_equal(const Cell& cell);
  Lits selected(const Cell& cell, std::size_t width);
  [[noreturn]] static void refuse(const Cell& cell, const std::string& why);

  proof::Aig& graph_;
  Arithmetic words_;
  std::function<Lit()> unknown_;
  std::unordered_map<int, Place> driver_;
  std::unordered_map<int, Lit> value_, held_;
  std::unordered_map<const Cell*, std::vector<Lits>> memories_;
};

/// Connects each clock pin to the input that it is, where only constants, buffers and inverters
/// stand between them; an inverted one gets the other polarity. Others stay as they are.
void connect_clocks(Module& module);

/// A cell that is no part of what a module does: an assertion, a text that is printed.
bool is_no_logic(const Cell& cell);

}  // namespace cosim::equiv
