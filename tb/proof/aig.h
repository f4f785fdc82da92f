// And-inverter graphs with registers, as AIGER has them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace cosim::proof {

class Aig {
 public:
  /// 2 * node, or 2 * node + 1 where it is inverted; 0 is false and 1 is true.
  using Lit = std::uint32_t;
  static Lit inverted(Lit a) { return a ^ 1U; }

  Lit input();
  /// A register that begins as `first`; next() says what it holds from the second clock on.
  Lit latch(bool first = false);
  void next(Lit latch, Lit value);

  Lit both(Lit a, Lit b);
  Lit either(Lit a, Lit b) { return inverted(both(inverted(a), inverted(b))); }
  Lit differ(Lit a, Lit b);
  Lit choose(Lit condition, Lit then, Lit otherwise);

  std::size_t inputs() const { return inputs_.size(); }
  std::size_t gates() const { return known_.size(); }
  std::size_t latches() const { return latches_.size(); }

  /// Binary AIGER 1.0 with the one output `bad`; input i is called pI.
  std::string aiger(Lit bad) const;

  /// The values of `watched` on every clock, from the first state on, where `in` holds those of the
  /// inputs, a row a clock; an input that a row lacks is 0.
  std::vector<std::vector<bool>> run(const std::vector<std::vector<bool>>& in,
                                     const std::vector<Lit>& watched) const;

  /// Random inputs, 64 runs at once for at most so many clocks: those of a run until `bad` is 1;
  /// none where it never was. In each run an input is held, or changes often or rarely.
  std::vector<std::vector<bool>> tried(Lit bad, std::size_t clocks) const;

 private:
  struct Latch {
    std::uint32_t node = 0;
    bool first = false;
    Lit next = 0;
  };
  enum class Kind { constant, input, latch, both };
  struct Node {
    Kind kind = Kind::constant;
    Lit a = 0, b = 0;  ///< of both; of an input or a latch, `a` is which one
  };
  Lit add(Kind kind, Lit a, Lit b = 0);

  std::vector<Node> nodes_{{}};
  std::vector<std::uint32_t> inputs_;
  std::vector<Latch> latches_;
  std::map<std::pair<Lit, Lit>, Lit> known_;
};

}  // namespace cosim::proof
