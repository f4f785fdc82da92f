// Where the cells of a model's tables are in the RTL.
#pragma once

#include <cstddef>
#include <functional>
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

/// What is asked of RTL: width and first_word as of Rtl.
struct WiresOf {
  std::function<int(const std::string&)> width, first_word;
};
/// The cells of a table, which `kind` names in errors: input, output or register. A memory's word
/// is a wire of its own. An input that is no pin is 0 bits of none. InputError where the RTL has no
/// such wire or one of another width.
std::vector<RtlCell> located_fields(const WiresOf& rtl, const std::string& design, const char* kind,
                                    const std::vector<Field>& fields);
/// The same of wires.
template <class AnyRtl, class AnyWire>
std::vector<RtlCell> located(const AnyRtl& rtl, const std::string& design, const char* kind,
                             const std::vector<AnyWire>& table) {
  std::vector<Field> fields;
  for (const AnyWire& w : table) fields.push_back(w.field);
  return located_fields({[&](const std::string& wire) { return rtl.width(wire); },
                         [&](const std::string& memory) { return rtl.first_word(memory); }},
                        design, kind, fields);
}

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
