// Logic as a graph of gates: each gate stands once, and constants are folded as it is made.
//
// The room in short. A model runs on Number (number.h), a value type whose bits are Bit of one
// Graph; to_blif() (blif.h) writes named bits of it; read_blif() gives what a tool wrote as plain
// Cells, and placed() puts Cells into a Graph.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
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
  friend constexpr bool operator==(Bit a, Bit b) { return a.code == b.code; }
  friend constexpr Bit operator!(Bit a) { return {a.code ^ 1}; }
};
inline constexpr Bit no{0}, yes{1};

enum class Gate : std::uint8_t {
  constant,  ///< number 0 of every graph, and no other: false
  input,     ///< free
  and_gate,  ///< a and b
  xor_gate,  ///< a or b, not both; of bits that are not inverted
  mux,       ///< b where a holds, else c
};

class Graph {
 public:
  Graph();

  /// A new free bit.
  Bit input();
  Bit and_of(Bit a, Bit b);
  Bit or_of(Bit a, Bit b) { return !and_of(!a, !b); }
  Bit xor_of(Bit a, Bit b);
  /// b where a holds, else c.
  Bit mux(Bit a, Bit b, Bit c);
  /// Bit number i of `table`, where i is the number whose bits are `of`, lowest first; at most 6.
  Bit lut(std::span<const Bit> of, std::uint64_t table);
  /// Whether any bit of a is not the one of b.
  Bit differ(std::span<const Bit> a, std::span<const Bit> b);

  struct Made {
    Gate kind = Gate::constant;
    Bit a{}, b{}, c{};  ///< what it reads: gates of smaller numbers
  };
  /// All gates, by number.
  const std::vector<Made>& gates() const { return gates_; }
  /// The free bits, in the order in which they were made.
  const std::vector<Bit>& inputs() const { return inputs_; }

 private:
  Bit made(Gate kind, Bit a, Bit b, Bit c = no);

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
  std::unordered_map<Made, std::uint32_t, Hash, Same> known_;
};

/// Puts the gates of another graph into this one, and gives what each is here, by number. `known`:
/// what those are that are not to be made, the free ones among them.
std::vector<Bit> placed(Graph& graph, const Graph& from, const std::map<std::size_t, Bit>& known);
/// What a bit of `from` is here.
inline Bit placed_at(const std::vector<Bit>& gates, Bit bit) {
  return bit.is_inverted() ? !gates[bit.gate()] : gates[bit.gate()];
}

/// 64 runs of a graph at once: what each gate gives, by number, where input number i is given
/// inputs[i]; bit r of each word is run r.
std::vector<std::uint64_t> run(const Graph& graph, std::span<const std::uint64_t> inputs);
/// What a bit is in these runs.
inline std::uint64_t in_runs(const std::vector<std::uint64_t>& gates, Bit bit) {
  return gates[bit.gate()] ^ (bit.is_inverted() ? ~std::uint64_t{0} : 0);
}

}  // namespace cosim::nets
