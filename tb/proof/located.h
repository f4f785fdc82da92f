// Where the cells of a model's tables are in the RTL's formula.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tb/proof/machine.h"
#include "tb/proof/rtl.h"

namespace cosim::proof {

/// A cell in the RTL: bits of a wire from `low` up.
struct RtlCell {
  std::string wire;
  int low = 0;
  int width = 1;
};

/// The cells of `table`, which `kind` names in errors: input, output or register. A memory's word
/// is a wire of its own. InputError where the RTL has no such wire or one of another width.
std::vector<RtlCell> located(const Rtl& rtl, const std::string& design, const char* kind,
                             const std::vector<Wire>& table);

/// Bits of a free symbol of the RTL.
struct Piece {
  std::size_t free = 0;  ///< index of Rtl::free()
  int low = 0;
  int width = 1;
};
/// What a cell is made of, highest bits first; empty where it is made of anything else.
std::vector<Piece> pieces_of(const Rtl& rtl, const RtlCell& cell);

/// What the RTL gives the cell during the clock, and after it. After it the cell must be made of
/// registers alone.
Expression during(const Rtl& rtl, const RtlCell& cell);
Expression after(const Rtl& rtl, const RtlCell& cell);

/// Codes one behind the other, highest first.
Expression joined(const std::vector<Expression>& codes);

}  // namespace cosim::proof
