// The RTL as formulas, by yosys.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tb/proof/expression.h"
#include "tb/proof/yosys.h"

namespace cosim::proof {

/// One clock of a machine as yosys writes it for SMT-LIB 2, but without its notion of a state: each
/// register and each input is a symbol, and all else is defined from them.
class Rtl {
 public:
  /// Reads what yosys wrote of the machine `top`. Under an asynchronous reset a register's net is
  /// made of the register and, where the reset is given, of a constant; pieces() then looks
  /// through.
  Rtl(std::string top, const std::string& smt2, bool asynchronous_reset = false);

  /// A symbol that the definitions need and do not give: an input or a register, or some bits of
  /// one.
  struct Free {
    std::string symbol;
    int width = 1;
    bool is_bool = false;
    std::string sort() const { return is_bool ? boolean : bit_vector(width); }
    std::string after;  ///< what it is after the clock, a term; empty where it is no register
  };
  const std::vector<Free>& free() const { return free_; }
  /// The ports of the top, its clocks aside.
  const std::vector<std::string>& inputs() const { return inputs_; }
  const std::vector<std::string>& outputs() const { return outputs_; }
  /// The definitions, to stand behind those of the free symbols.
  const std::string& definitions() const { return definitions_; }
  /// The free symbols that a wire of the top is made of, highest bits first; empty where it is made
  /// of anything else. Indices of free().
  std::vector<std::size_t> pieces(const std::string& wire) const;
  /// What the registers hold at first, terms; empty where none has an initial value.
  const std::vector<std::string>& initial() const { return initial_; }
  /// What the RTL asserts itself of a clock, terms; empty where it asserts nothing.
  const std::vector<Expression>& asserted() const { return asserted_; }
  /// How many bits a wire of the top has, the word "store[3]" of a memory too; 0 where there is
  /// none.
  int width(const std::string& wire) const;
  /// The number that the RTL gives the first word of a memory; 0 where there is no such memory.
  int first_word(const std::string& memory) const;
  /// What a symbol of the definitions chooses between; none where it is no choice.
  std::optional<Choice> choice(const std::string& symbol) const;
  /// A wire of the top, as a code of its width. InputError where there is none.
  Expression wire(const std::string& name) const;

 private:
  void read_line(const std::string& line);
  void read_port(const std::string& line);
  std::string without_reset(const std::string& symbol) const;
  void define(const std::string& name, const std::string& sort, const std::string& body);

  std::string top_;
  std::vector<Free> free_;
  std::vector<std::string> inputs_, outputs_;
  std::string definitions_;
  struct Wire {
    std::string sort;
    std::string body;
  };
  std::map<std::string, Wire> wires_;  // by symbol
  std::vector<std::string> initial_;
  std::vector<Expression> asserted_;
  bool asynchronous_reset_ = false;
  bool in_relation_ = false;
  bool in_initial_ = false;
};

/// For yosys, behind flat_commands(): those, with "; " before them, that write the formulas of
/// `source` into a folder; and the formulas that stand there. InputError where they are of no
/// machine.
std::string formula_commands(const Source& source, const std::filesystem::path& folder);
Rtl formulas_in(const std::filesystem::path& folder, const Source& source);

/// A term, or definitions, with the symbols of the clock after.
std::string on_next_clock(const std::string& text);
Expression on_next_clock(const Expression& term);

/// A term of either sort as a code: of Bool, one bit.
Expression as_code(const Expression& term);
/// A code of one bit or more as a term of `sort`.
Expression as_sort(const Expression& code, const std::string& sort);

}  // namespace cosim::proof
