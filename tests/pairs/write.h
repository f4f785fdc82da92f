// Writes expressions and statements: as they are, or in other words.
#pragma once

#include <map>
#include <string>

#include "tests/pairs/design.h"

namespace cosim::pairs {

class Writer {
 public:
  Writer(const Design& design, Random& random, bool in_other_words)
      : design_(design), random_(random), other_(in_other_words) {}

  /// Names that are in force; in `lines` what has to stand before, as wires that were named.
  std::map<std::string, Signal> scope;
  std::map<std::string, int> opened;  // memories of so many words that are registers
  std::string lines;
  bool may_declare = false;  // types in the module: of the old RTL in SystemVerilog
  bool may_name = true;      // wires: not where a loop or a block gives names their values

  /// For a context of that type, in which all operands are widened to it.
  std::string expr(const Expr& e, Type context);
  std::string expr(const Expr& e) { return expr(e, type_of(e)); }
  /// The right side of an assignment to so many bits.
  std::string assigned(const Expr& e, int width);
  /// A wire that has the value in that context, and its name.
  std::string wire(Type type, const std::string& text);
  std::string wired(const Expr& e, Type context);

  std::string declared(const std::string& kind, const Signal& s) const;
  std::string statements(const std::vector<Stmt>& body, const Signal& target,
                         const std::string& gets, const std::string& indent);
  /// The value that the statements leave, as a wire: each assignment makes another one of the one
  /// before.
  std::string flat(const std::vector<Stmt>& body, const Signal& target, std::string now,
                   bool at_once);
  std::string inlined(const Function& f, const std::vector<Expr>& actual);

  std::string fresh(const std::string& stem);
  static std::string word_of(const std::string& memory, int i) {
    return memory + '_' + std::to_string(i);
  }
  bool rarely(int percent) { return other_ && random_.percent(percent); }

 private:
  std::string literal(const Expr& e);
  std::string whole(const std::string& name) const;
  std::string part(const std::string& name, int low, int count);
  std::string select(const std::string& name, int low, int count);
  std::string indexed(const std::string& name, const Expr& position, int count);
  std::string member(const std::string& name, int low, int count);
  std::string labels(const Stmt& s);
  std::string unary(const Expr& e, Type context);
  std::string binary(const Expr& e, Type context);
  std::string compare(const Expr& e);
  std::string shift(const Expr& e, Type context);
  std::string staged(const Expr& e, Type context);
  std::string divided(const Expr& e, Type context);
  std::string power(const Expr& e, Type context);
  std::string matches(const Stmt& s, std::size_t item);
  std::string truth(const Expr& e);
  std::string target_of(const Stmt& s, const Signal& target);
  std::string chain(const Stmt& s, const Signal& target, const std::string& gets,
                    const std::string& indent);

  const Design& design_;
  Random& random_;
  bool other_;
  int names_ = 0;
};

/// Their declarations, of the loops within too.
std::string loop_variables(const std::vector<Stmt>& body, const std::string& indent);
std::string text_of(long value);
/// {count{what}}
std::string repeated(int count, const std::string& what);
std::string range(const Signal& s);
std::string range(int width);
std::string sized(const std::string& bits, bool is_signed = false);

}  // namespace cosim::pairs
