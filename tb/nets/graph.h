// Logic and registers as a graph of gates: each gate stands once, and constants are folded as it is
// made. It is the one graph of the harness: a model, RTL, both of two RTLs, and a question of an
// engine are graphs.
//
// The room in short. A model runs on Number (number.h), a value type whose bits are Bit of one
// Graph; aiger() writes bits of it for other engines. read_btor2() (btor2.h) gives a golden model
// that was exported, and its placed() makes gates of it by the operations of words.h. Runs (runs.h)
// simulates a Graph.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace cosim::nets {

/// A bit: what a gate of a graph gives, or its inverse. Bits of two graphs must not be mixed, but
/// `no` and `yes` are those of every graph.
struct Bit {
  std::uint32_t code = 0;  ///< twice the gate's number, and 1 more for the inverse
  constexpr std::size_t gate() const { return code >> 1; }
  constexpr bool is_inverted() const { return (code & 1) != 0; }
  constexpr bool is_constant() const { return code < 2; }
  friend constexpr auto operator<=>(Bit a, Bit b) = default;
  friend constexpr Bit operator!(Bit a) { return {a.code ^ 1}; }
  /// Its inverse, if so.
  friend constexpr Bit operator^(Bit a, bool inverts) { return {a.code ^ (inverts ? 1U : 0U)}; }
};
using Bits = std::vector<Bit>;
inline constexpr Bit no{0}, yes{1};
constexpr Bit constant(bool value) { return no ^ value; }
/// What the gate of that number gives.
constexpr Bit gate_bit(std::size_t number) { return {static_cast<std::uint32_t>(2 * number)}; }

enum class Gate : std::uint8_t {
  constant,  ///< number 0 of every graph, and no other: false
  input,     ///< free
  latch,     ///< what a register holds
  and_gate,  ///< a and b
  xor_gate,  ///< a or b, not both; of bits that are not inverted
  mux,       ///< b where a holds, else c
};

class Graph {
 public:
  Graph();

  /// A new free bit; a word of its own.
  Bit input();
  /// A bit of a word of that name; those of a word are added from the lowest on.
  Bit input(const std::string& word);
  /// One that is mostly 0 where inputs are made by chance.
  Bit seldom();
  /// A register that begins as `first`; next() says what it holds from the second clock on.
  Bit latch(bool first = false);
  void next(Bit latch, Bit value);

  Bit and_of(Bit a, Bit b);
  Bit or_of(Bit a, Bit b) { return !and_of(!a, !b); }
  Bit xor_of(Bit a, Bit b);
  /// b where a holds, else c.
  Bit mux(Bit a, Bit b, Bit c);
  /// Bit number i of `table`, where i is the number whose bits are `of`, lowest first; at most 6.
  Bit lut(std::span<const Bit> of, std::uint64_t table);
  Bit all_of(std::span<const Bit> bits);
  /// Whether any bit of a is not the one of b.
  Bit differ(std::span<const Bit> a, std::span<const Bit> b);

  struct Made {
    Gate kind = Gate::constant;
    Bit a{}, b{}, c{};         ///< what it reads: gates of smaller numbers
    std::uint32_t number = 0;  ///< which of the inputs or of the latches it is
    bool is_logic() const { return kind >= Gate::and_gate; }
  };
  struct Latch {
    Bit now{};
    bool first = false;
    Bit next{};
  };
  /// All gates, by number.
  const std::vector<Made>& gates() const { return gates_; }
  /// The free bits, in the order in which they were made.
  const std::vector<Bit>& inputs() const { return inputs_; }
  const std::vector<Latch>& latches() const { return latches_; }
  /// The inputs that are one word, by their numbers, the lowest bit first.
  const std::vector<std::vector<std::size_t>>& words() const { return words_; }
  bool is_seldom(std::size_t input) const { return seldom_.contains(input); }
  /// The gates that these read, themselves among them, by number; `over_clocks`: also what the
  /// latches hold next.
  std::vector<bool> cone(std::span<const Bit> roots, bool over_clocks = false) const;

 private:
  Bit made(Gate kind, Bit a, Bit b, Bit c = no);
  Bit leaf(Gate kind, std::size_t number);

  struct Hash {
    std::size_t operator()(const Made& m) const;
  };
  struct Same {
    bool operator()(const Made& m, const Made& n) const {
      return m.kind == n.kind && m.a == n.a && m.b == n.b && m.c == n.c;
    }
  };
  std::vector<Made> gates_;
  std::vector<Bit> inputs_;
  std::vector<Latch> latches_;
  std::vector<std::vector<std::size_t>> words_;
  std::map<std::string, std::size_t> word_at_;
  std::set<std::size_t> seldom_;
  std::unordered_map<Made, std::uint32_t, Hash, Same> known_;
};

/// What a bit of another graph is here: `gates` has it for each gate of the other.
inline Bit placed_at(const Bits& gates, Bit bit) { return gates[bit.gate()] ^ bit.is_inverted(); }
/// A gate of another graph, and_gate, xor_gate or mux, made in this one of what its bits are here.
Bit remade(Graph& graph, const Graph::Made& gate, const Bits& gates);
/// Puts the gates of another graph into this one, and gives what each is here, by number. `known`:
/// what those are that are not to be made, the free ones and the latches among them.
Bits placed(Graph& graph, const Graph& from, const std::map<std::size_t, Bit>& known);

/// Puts those gates of another graph into this one that are asked for.
class Placing {
 public:
  Placing(const Graph& from, Graph& to);
  /// What a gate of the one is in the other.
  void give(Bit gate, Bit is);
  /// Makes all that these read. Inputs that are not given are new ones.
  void make(std::span<const Bit> roots);
  /// What a bit that was made or given is.
  Bit of(Bit bit) const { return placed_at(all_, bit); }

 private:
  const Graph& from_;
  Graph& to_;
  Bits all_;
  std::vector<bool> is_made_;
};

/// A bit with a name: printable characters; none begins with '$'.
struct Port {
  std::string name;
  Bit bit;
};

/// Binary AIGER 1.0. An input or a latch has the name that `names` gives its gate, else input i is
/// called pI, latch i rI. A latch that begins as 1 is kept inverted.
std::string aiger(const Graph& graph, const Bits& outputs,
                  const std::map<std::size_t, std::string>& names = {});

}  // namespace cosim::nets
