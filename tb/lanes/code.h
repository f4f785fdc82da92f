// From a design's nets to the code of its lanes, and that as C++.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "tb/lanes/layout.h"
#include "tb/nets/blif.h"
#include "tb/nets/played.h"
#include "tb/proof/rtl_nets.h"

namespace cosim::lanes {

// Straight-line code on planes: a word of as many bits as there are lanes, lane l in bit l. Each
// statement is one cell of at most three inputs.

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

/// What the code of a shape is made of. The memory is the same for all.
struct Code {
  Straight clock;  ///< draws the inputs, clocks and compares RTL and model
  Straight quiet;  ///< the same where `loud` gives no lane (quiet.h), if there is such a clock
  Straight loud;
  Straight stretch;    ///< before the first clock of a stretch: draws how often pins change
  Straight reset;      ///< one clock of the RTL alone, with the inputs that reset it
  Straight take_over;  ///< behind the last of them: what the model takes over from the RTL
  bool has_quiet = false;
  int reset_clocks = 0;
  bool is_asked = false;  ///< plane number 0 says in which lanes a job is over
  Layout layout;
};

/// InputError where the RTL is not what the model's tables say, or cannot run in lanes.
Code code_of(const nets::Played& played, const proof::RtlNets& rtl);

/// Nets as cells of at most three inputs, by abc: the outputs in their order from the inputs in
/// theirs. InputError, with `name`, where abc cannot be run.
nets::Cells mapped(const std::string& name, const nets::Graph& graph,
                   const std::vector<nets::Bit>& inputs, const std::vector<nets::Bit>& outputs);

/// As a source of C++ without anything of this project. It defines, for planes of V, words of
/// `lanes` bits, 64, 256 or 512,
///
///   int cosim_lanes                                      so many
///   char cosim_lanes_layout[]                            the layout of the memory, in words
///   void cosim_lanes_reset(V* m)                         resets the RTL
///   void cosim_lanes_take_over(V* m)                     gives the model what no reset reaches
///   void cosim_lanes_choose(V* m, const V* which, const V* from, uint64_t planes)
///                                                        takes over these lanes
///   void cosim_lanes_clear(V* m, const V* which, uint64_t planes)
///                                                        makes these lanes 0
///   int64_t cosim_lanes_run(V* m, const V* active, uint64_t from, uint64_t to, V* differ,
///                           uint64_t* left_out)
///
/// The last one runs clocks number from .. to - 1 of the cases. It ends after the first on which
/// any of the lanes at work differs, or its job is over, and returns its number and those that
/// differ; else -1.
std::string to_text(const Code& code, int lanes);

}  // namespace cosim::lanes
