// Where the cells of a model's tables are in the RTL.
#pragma once

#include <string>
#include <vector>

#include "model/core/fields.h"
#include "tb/nets/model.h"
#include "tb/proof/rtl_nets.h"

namespace cosim::proof {

/// A cell in the RTL: bits of a wire from `low` up.
struct RtlCell {
  std::string wire;
  int low = 0;
  nets::Bits bits;
};

/// The cells of a table, which `kind` names in errors: input, output or register. A memory's word
/// is a wire of its own. An input that is no pin has no bits. InputError where the RTL has no
/// such wire or one of another width.
std::vector<RtlCell> located_fields(const RtlNets& rtl, const std::string& design, const char* kind,
                                    const std::vector<Field>& fields);
/// The same of wires.
std::vector<RtlCell> located(const RtlNets& rtl, const std::string& design, const char* kind,
                             const std::vector<nets::Wire>& table);

}  // namespace cosim::proof
