// A graph of gates run on planes: words of as many bits as there are lanes, lane l in bit l. What
// is compiled for that (tb/lanes) is quicker by far, but takes seconds to compile: this is for
// graphs that are run some thousand times.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/core/value.h"
#include "tb/nets/graph.h"

namespace cosim::nets {

inline constexpr std::size_t plane_lanes = 512;

struct alignas(64) Plane {
  std::array<std::uint64_t, plane_lanes / 64> words{};

  static Plane all(bool is) {
    Plane p;
    p.words.fill(is ? ~std::uint64_t{0} : 0);
    return p;
  }
  bool lane(std::size_t l) const { return (words[l / 64] >> (l % 64) & 1) != 0; }
  void set(std::size_t l) { words[l / 64] |= std::uint64_t{1} << (l % 64); }
  bool any() const {
    std::uint64_t some = 0;
    for (const std::uint64_t w : words) some |= w;
    return some != 0;
  }
  friend bool operator==(const Plane&, const Plane&) = default;
};
#define COSIM_PLANE_OPERATOR(op)                                                            \
  inline Plane operator op(const Plane& a, const Plane& b) {                                \
    Plane p;                                                                                \
    for (std::size_t i = 0; i < p.words.size(); ++i) p.words[i] = a.words[i] op b.words[i]; \
    return p;                                                                               \
  }
COSIM_PLANE_OPERATOR(&)
COSIM_PLANE_OPERATOR(|)
COSIM_PLANE_OPERATOR(^)
#undef COSIM_PLANE_OPERATOR
inline Plane operator~(const Plane& a) { return a ^ Plane::all(true); }

/// One gate, on planes by their places in a memory.
struct PlaneStep {
  enum Act : std::uint8_t { both, not_a, not_b, neither, differ, choice, turned_choice } act;
  std::uint32_t a, b, c, gives;
};

/// A root in the memory of planes.
struct PlaneRoot {
  std::uint32_t at = 0;  ///< 0 where nothing needs it, or where it is a constant
  bool is_inverted = false;
};

/// A flip-flop: in `lanes` it takes `next` at an edge.
struct PlaneFlipFlop {
  std::uint32_t held = 0;
  PlaneRoot next;
  Plane lanes;
};

/// The gates that some bits of a graph come to.
class Planes {
 public:
  /// Only the first `lanes` lanes are run.
  Planes(const Graph& graph, std::span<const Bit> roots, std::size_t lanes = plane_lanes);

  /// What the free bit is in each lane from now on; all are 0 at first. Nothing where no root needs
  /// it.
  void give(Bit input, const Plane& plane);
  void run();
  /// What a root, or a free bit that one needs, is in each lane that is run, since the last run.
  Plane get(Bit root) const;

  PlaneRoot root(Bit root) const { return {place_[root.gate()], root.is_inverted()}; }
  /// `held` is a free bit that a root needs, `next` a root.
  PlaneFlipFlop flip_flop(Bit held, Bit next, const Plane& lanes) const {
    return {place_[held.gate()], root(next), lanes};
  }
  /// An edge of the clock: all take at once what the last run made.
  void edge(std::span<const PlaneFlipFlop> flip_flops);
  /// The number that roots, lowest first, are in a lane that is run.
  Word value(std::span<const PlaneRoot> roots, std::size_t lane) const;
  /// The lanes that are run in which roots, lowest first, are not `value`.
  Plane differing(std::span<const PlaneRoot> roots, Word value) const;
  /// How many gates are run.
  std::size_t gates() const { return steps_.size(); }

 private:
  // A memory of one word a plane stays near the processor, where that is lanes enough.
  bool is_narrow() const { return words_ == 1; }

  std::size_t words_;                 // of a plane in the memory
  std::vector<std::uint32_t> place_;  // of a gate, by number; 0, a plane of zeros, of the constant
  std::vector<PlaneStep> steps_;
  std::vector<std::uint32_t> ends_;  // of the steps alike that follow each other
  std::vector<Plane> memory_, taken_;
};

}  // namespace cosim::nets
