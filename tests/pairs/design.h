// A random design: what both RTLs of a pair are written from.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace cosim::pairs {

/// The same numbers on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool percent(int n) { return below(100) < n; }
  template <class T>
  const T& of(const std::vector<T>& all) {
    return all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
  }
  std::string bits(int width);

 private:
  std::mt19937_64 engine_;
};

struct Type {
  int width = 1;
  bool is_signed = false;
};

/// A net, a variable, an argument, a parameter, a loop variable.
struct Signal {
  std::string name;
  Type type;
  int low = 0;             // the index of the least significant bit, or of the most significant one
  bool ascending = false;  // [low:high]
  bool is_vector = true;   // parts of it may be selected
  std::string text;        // what is written for its value, where that is not the name
};

enum class Kind {
  constant,  // bits, most significant first; `op` is "unsized" for a decimal number of 32 bits
  name,
  part,     // name, low, count: positions, counted from the least significant bit
  indexed,  // name, count, args[0]: the lowest position
  word,     // of a memory: name, args[0]
  unary,
  binary,
  compare,  // == < ...
  logical,  // && ||
  shift,
  power,
  ternary,
  concat,
  replicate,  // count, args[0]
  cast,       // $signed, $unsigned
  size,       // count'(args[0])
  call
};

struct Expr {
  Kind kind = Kind::constant;
  std::string op;  // or the name
  std::string bits;
  Type type;  // of a constant, a name, a word and a call
  int low = 0, count = 0;
  std::vector<Expr> args;
};

/// Its own, as the language says, before the context widens it.
Type type_of(const Expr& e);
/// Of operands that are widened to each other.
Type common(Type a, Type b);

Expr constant(const std::string& bits, bool is_signed = false);
Expr number(int value);
Expr use(const Signal& signal);

enum class Does { assign, branch, choose, loop };
enum class Target { whole, part, indexed };

struct Stmt {
  Does does = Does::assign;
  Target target = Target::whole;
  int low = 0, count = 0;                 // of a part; the bound of a loop
  Expr index;                             // the lowest position
  Expr value;                             // or the condition, or the selector
  std::string word;                       // case, casez, casex; or the loop variable
  std::vector<Expr> items;                // constants, with the digits x, z and ?
  std::vector<std::vector<Stmt>> blocks;  // of branches and items, the default behind them
};

enum class Is { net, comb, clocked, memory, instance, generate };
enum class Reset { none, synchronous, asynchronous };

struct Write {
  Expr enable, address, data;
  int low = 0, count = 0;
};

struct Argument {
  Signal formal;
  Expr actual;
  bool is_typed = true;  // a parameter that keeps its type whatever it is given
};

/// What drives one signal, or is one memory.
struct Item {
  Is is = Is::net;
  Signal target;  // of a memory: a word of it
  bool is_output = false;
  Expr value;  // of a net, below an instance, or of one turn of a generate loop
  std::vector<Stmt> body;
  int clock = 0, reset = 0;
  Reset how = Reset::none;
  std::string initial;  // the reset value too
  int words = 0;
  bool from_file = false;
  std::vector<std::string> contents;
  std::vector<Write> writes;
  std::vector<Argument> ports, parameters;
  std::string loop;
  int turns = 0;
};

struct Function {
  Signal result, value;  // the value is the variable that the body works out
  std::vector<Signal> arguments;
  std::vector<Stmt> body;
};

struct Clock {
  std::string name;
  bool falls = false;
};

struct Design {
  bool is_sv = false;
  std::vector<Clock> clocks;
  std::vector<Signal> resets;  // active low where the name ends in _n
  std::vector<Signal> inputs;
  std::vector<Function> functions;
  std::vector<Item> items;
};

Design random_design(Random& random, bool is_sv);
/// Changes one thing, and says what.
std::string plant(Design& design, Random& random);

struct Written {
  std::string text;
  std::vector<std::pair<std::string, std::string>> files;
};

/// As it is, or the new RTL of a pair: the same in other words.
Written write_rtl(const Design& design, Random& random, bool is_gate);

}  // namespace cosim::pairs
