// Straight-line code on planes: a word of as many bits as there are lanes, lane l in bit l. Each
// statement is one cell of at most three inputs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "tb/nets/blif.h"

namespace cosim::lanes {

/// A value of the code: what a cell gives, or a plane of the memory as it was before the code.
using Value = std::size_t;
inline constexpr Value zero = 0, one = 1;

class Straight {
 public:
  /// What plane number i of the memory holds before the code.
  Value plane(std::size_t i);
  /// Bit number 4 c + 2 b + a of `table`.
  Value cell(std::uint8_t table, Value a, Value b, Value c);
  /// All outputs of a netlist whose inputs have these values. InputError for a table of more than
  /// three inputs, and for flip-flops.
  std::vector<Value> add(const nets::Cells& cells, std::span<const Value> inputs);

  /// Plane number i holds the value after the code.
  void store(std::size_t i, Value value) {
    if (value != plane(i)) stores_.push_back({i, value});
  }
  /// Lanes where the values differ, and `when` holds, are among those that the code gives.
  void compare(Value a, Value b, Value when = one);
  /// Counter number i counts the lanes at work in which the value does not hold.
  void count_without(std::size_t i, Value value) { counts_.push_back({i, value}); }

  /// Two planes from `first` on that are compared in all lanes, and are the same until one differs,
  /// become the first of them: what the other one would hold is compared when it would be stored,
  /// and the lanes that differ then are in `late`, to differ on the next run of the code. Gives
  /// what was merged.
  struct Merged {
    std::size_t kept, dropped;
  };
  std::vector<Merged> merge(std::size_t first);

  /// The body of a function, for a processor of so many registers, in C++ and in OpenCL C: M(i) is
  /// plane number i, T(table, a, b, c) a cell. `differ` becomes the lanes that differ.
  std::string text(std::size_t registers) const;

 private:
  struct Cell {
    std::uint8_t table = 0;
    std::array<Value, 3> of{};
    std::size_t plane = 0;
    bool is_plane = false;
  };
  struct Use {
    std::size_t number;
    Value value;
  };
  struct Comparison {
    Value a, b, when;
    bool is_late = false;
  };
  class Writer;

  // The first two are the constants.
  std::vector<Cell> cells_ = std::vector<Cell>(2);
  std::map<std::size_t, Value> planes_;
  std::vector<Use> stores_, counts_;
  std::vector<Comparison> comparisons_;
};

}  // namespace cosim::lanes
