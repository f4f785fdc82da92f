// Draws a design. Nothing in it is ever x: indexes that are read stay within, divisors are not 0,
// and every register and word has a value to begin with.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/pairs/design.h"

namespace cosim::pairs {

class Draw {
 public:
  Draw(Random& random, bool is_sv) : random_(random) { design_.is_sv = is_sv; }
  Design all();

 private:
  std::string name(const std::string& stem, int i) { return stem + std::to_string(i); }
  int width();
  Type type() { return {width(), random_.percent(35)}; }
  Signal signal(const std::string& name, Type type);
  void ports();
  static Expr make(Kind kind, const std::string& op, std::vector<Expr> args);
  Expr leaf();
  // A value of at most so many bits, so that it is a position within, with `count` bits from there
  // on.
  Expr position(int width, int count);
  Expr slice(int bits);
  Expr value(int depth);
  // A constant without a size may not stand within { }.
  static void unsized(Expr& e);
  // Products, quotients and powers of few bits: wide ones take the engines too long.
  Expr heavy(Type& target);
  Stmt assignment(const Signal& target, bool whole);
  std::vector<Stmt> block(const Signal& target, int depth);
  Stmt statement(const Signal& target, int depth);
  Stmt choice(const Signal& target, int depth);
  std::vector<Stmt> body(const Signal& target, bool is_complete);
  Function function(int i);
  Item net(const std::string& name, Type type, std::vector<Stmt> body);
  void clocked(Item& item);
  void memory(int i);
  void add(const Item& item);
  void item(int i);
  // A module of its own: inputs that are cut or widened, and parameters of any type.
  void instance(int i);
  void generate(int i);

  Random& random_;
  Design design_;
  std::vector<Signal> scope_;
  bool can_call_ = true;
  int loops_ = 0;
};

}  // namespace cosim::pairs
