// And-inverter graphs with registers, as AIGER has them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
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
  /// A bit of a word of that name; those of a word are added from the lowest on.
  Lit input(const std::string& word);
  /// One that is mostly 0 where inputs are made by chance.
  Lit seldom();
  /// A register that begins as `first`; next() says what it holds from the second clock on.
  Lit latch(bool first = false);
  void next(Lit latch, Lit value);

  Lit and_of(Lit a, Lit b);
  Lit or_of(Lit a, Lit b) { return inverted(and_of(inverted(a), inverted(b))); }
  Lit xor_of(Lit a, Lit b);
  Lit choose(Lit condition, Lit then, Lit otherwise);

  std::size_t inputs() const { return inputs_.size(); }
  std::size_t gates() const { return known_.size(); }
  std::size_t latches() const { return latches_.size(); }

  /// Binary AIGER 1.0 with the one output `bad`; input i is called pI, latch i rI. One that begins
  /// as 1 is kept inverted. `names`, where there are any: those of the inputs.
  std::string aiger(Lit bad, const std::vector<std::string>& names = {}) const;

  /// The values of `watched` on every clock, from the first state on, where `in` holds those of the
  /// inputs, a row a clock; an input that a row lacks is 0.
  std::vector<std::vector<bool>> run(const std::vector<std::vector<bool>>& in,
                                     const std::vector<Lit>& watched) const;

  /// The inputs that are one word, by their numbers, the lowest bit first; one alone is a word too.
  const std::vector<std::vector<std::size_t>>& words() const { return words_; }

  bool is_seldom(std::size_t input) const { return seldom_.contains(input); }

  class Runs;

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
  /// Node 0 is the constant; what a gate reads stands before it.
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Latch>& registers() const { return latches_; }

 private:
  Lit add(Kind kind, Lit a, Lit b = 0);

  std::vector<Node> nodes_{{}};
  std::vector<std::uint32_t> inputs_;
  std::vector<Latch> latches_;
  std::map<std::pair<Lit, Lit>, Lit> known_;
  std::vector<std::vector<std::size_t>> words_;
  std::map<std::string, std::size_t> word_at_;
  std::set<std::size_t> seldom_;
};

/// 64 runs of a graph side by side, a bit of each number for each; from the first state on.
class Aig::Runs {
 public:
  explicit Runs(const Aig& graph);
  /// The state of the next clock, a number for each latch.
  void begin(std::vector<std::uint64_t> state) { state_ = std::move(state); }
  /// The next clock, with these inputs.
  void clock(const std::vector<std::uint64_t>& inputs);
  /// What it is on this clock.
  std::uint64_t of(Lit lit) const { return value_[lit / 2] ^ (0 - std::uint64_t{lit & 1U}); }

 private:
  const Aig& graph_;
  std::vector<std::uint32_t> gates_;
  std::vector<std::uint64_t> value_, state_;
};

}  // namespace cosim::proof
