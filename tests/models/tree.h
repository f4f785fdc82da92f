// A random clocked model as a tree, which is written as a struct of C++ and as Verilog.
#pragma once

#include <random>
#include <string>
#include <vector>

namespace cosim::models {

struct Type {
  int width = 1;
  bool is_signed = false;
};
inline std::string cpp(Type t) {
  return t.width == 1 && !t.is_signed
             ? "Bit"
             : (t.is_signed ? "Int<" : "UInt<") + std::to_string(t.width) + ">";
}
inline std::string verilog(Type t) {
  return (t.is_signed ? "signed [" : "[") + std::to_string(t.width - 1) + ":0] ";
}

/// `op` is a key of operators() (operators.cpp), or "variable", "constant", "int" (a literal or a
/// loop variable of C++) or "call".
struct Expr {
  std::string op = "";
  Type type = {};
  std::vector<Expr> args = {};
  std::string cpp = "", verilog = "";  ///< the names of a variable; of the function that is called
  long value = 0;                      ///< of a constant; the lowest bit of a slice
  bool is_int() const { return op == "int"; }
};
struct Variable {
  Type type = {};  ///< of an element
  std::string cpp = "", verilog = "";
  int size = 0;  ///< of an array; 0: it is none
  long initial = 0;
};
enum class Does { assign, choose, repeat, select, leave, stop, merge, copy };
/// assign: target = value, or target OP= value where op is not empty. Its target is all of a
/// variable, or `part`, as "slice", "bit", "bits" or "element" at args[0].
/// choose: if (value) blocks[0] else blocks[1]. repeat: for; with a value, while a local variable
/// that begins at it and is shifted to the right is not 0. copy: g = h, two registers that are
/// structs, or h = g if `number` is 1. select: switch over value, whose last block is the default
/// one. leave: return. stop: break, where value holds.
struct Stmt {
  Does does;
  Variable target = {};
  std::string part = "", op = "";
  int low = 0, width = 0;  ///< of the part
  std::vector<Expr> args = {};
  Expr value = {};
  std::vector<std::vector<Stmt>> blocks = {};
  int number = 0;  ///< of a loop variable, of a copy
  int count = 0;   ///< how often a loop is run
};
/// if (condition) return yes; return no;
struct Function {
  std::string name;
  Type result;
  std::vector<Variable> parameters;
  Expr condition = {}, yes = {}, no = {};
};
struct Model {
  std::vector<Variable> inputs, outputs, registers, locals;
  std::vector<Function> functions;
  std::vector<Expr> initial;  ///< of the locals, then of the outputs
  std::vector<Stmt> body;
};

/// How an operator is written: $0, $1, $2 are its operands, $t its type, $w its width, $l its
/// lowest bit.
struct Operator {
  const char *cpp, *verilog;
  bool is_raw;          ///< its operands in Verilog are bits without a sign
  const char* changed;  ///< another operator in its place; empty: none
};
const Operator& written(const std::string& op);

Model drawn(unsigned seed);
std::string struct_of(const Model&, const std::string& name);
/// Module t, and with change >= 0 another operator, constant, condition or a missing assignment;
/// `sites` becomes the number of places that can be changed.
std::string module_of(const Model&, int change, int& sites);

}  // namespace cosim::models
