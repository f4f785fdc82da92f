// The old RTL and the new one side by side, as one graph with one output.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tb/equiv/equiv.h"
#include "tb/equiv/side.h"
#include "tb/nets/graph.h"
#include "tb/proof/reach.h"

namespace cosim::equiv {

inline constexpr Bit unknown_begin{~std::uint32_t{0}};

struct Product {
  Graph graph;
  Bit bad = no;                       ///< an output differs, or what is cut
  Bit differ = no;                    ///< an output differs
  std::set<Bit> free;                 ///< what memories that are one read, and the old RTL's x
  std::map<Name, Bit> inputs;         ///< as both get them
  std::map<std::string, int> widths;  ///< of the inputs
  std::map<Name, Bit> beginnings;     ///< of registers of that name, the same in both
  /// By register, what each begins as; of the old RTL `unknown_begin` where that may be any.
  Bits gold_begins, gate_begins;
  std::map<Name, Bit> gold, gate;  ///< the outputs that are compared, by the old names
  std::map<Name, Bit> any;         ///< the old RTL says x
  Bit held = yes;           ///< it is after the reset, and what is assumed held on every clock
  std::size_t matched = 0;  ///< registers that both have by name
  std::map<std::size_t, std::string> names;  ///< of inputs and latches of the graph, by gate
  bool alone_any = false;  ///< the old RTL has a register without initial value that no other has
};

/// How the registers of both stand.
enum class Registers {
  two,  ///< from their initial values on
  /// Those that both have by name and begin alike are one, any state is the first, and `bad` is
  /// also that the two would make it differ. If that is never, the RTLs are equal.
  one,
};

/// Memories of both that are one: of the old RTL and of the new. What they read is the same free
/// value in both, and `bad` is also that another word is written, or another address read.
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// The values of the old RTL's x bits, those of registers without an initial value behind them, a
/// row a clock; 0 where there is none.
using Filler = std::vector<std::vector<bool>>;

/// What the old RTL's x is.
struct Unknown {
  /// Without any, and not free, what the new RTL's is where they have as many, else 0: one of its
  /// values. With some, the old RTL is there once for each: an output that is another with one of
  /// them is `any`.
  std::vector<Filler> fillers = {};
  bool free = false;  ///< without fillers: any value, and Product::free has it
};

Product product_of(const Question& question, Registers registers, const Unknown& unknown,
                   const Pairs& memories);

/// How many bits a row of a filler has.
std::size_t unknown_bits(const Question& question);

/// The product of RTLs whose memories are cut, with what they read as x: `bad` is that an output
/// differs whatever they read, `any` the bits of which that is not known in one of both.
/// A stimulus for it is one for the RTLs as they are. The inputs have the same numbers.
Product whatever_is_free(const Product& product);

/// A memory of a side, its number there, and what the side's gates give its ports.
struct MemoryPorts {
  const Memory& memory;
  std::size_t number;
  const Side::Made& made;
};

/// Whether they read another address, or leave another word at some address, whichever it is.
/// They have as many words and read ports as each other.
Bit strays_of(Graph& graph, const MemoryPorts& gold, const MemoryPorts& gate);

/// Values of the old RTL's x: all 0, all 1, and some by chance, so that what depends on several
/// bits is seen to.
std::vector<Filler> first_fillers(std::size_t bits);

/// What is certain of the outputs that differ at the end of a stimulus.
struct Certain {
  bool any = false;            ///< one of them is the same with every value of the old RTL's x
  std::set<Name> open;         ///< those that are not, or of which it is not known
  std::vector<Filler> others;  ///< values with which one of `open` is another
};
Certain certain_of(const Question& question, const Product& product, const proof::Reached& reached);

}  // namespace cosim::equiv
