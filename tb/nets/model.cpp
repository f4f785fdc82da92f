#include "tb/nets/model.h"

#include <fmt/core.h>

namespace cosim::nets {

std::vector<Bit> free_bits(Model& model, const char* kind, const Field& field) {
  const std::string element = field.index < 0 ? "" : fmt::format(".{}", field.index);
  std::vector<Bit> bits;
  for (int i = 0; i < field.width; ++i) {
    bits.push_back(model.graph.input());
    model.ports.push_back({fmt::format("{}.{}{}[{}]", kind, field.name, element, i), bits.back()});
  }
  return bits;
}

// The ones' complement has no number below -(2^(width-1) - 1): its code 10..0 becomes 10..01.
FreeCell free_state(Model& model, const Field& field) {
  std::vector<Bit> code = free_bits(model, "state", field);
  if (!is_signed(field)) return {Number::unsigned_code(model.graph, code), code};
  if (field.format == Format::ones_complement) {
    Bit lowest = code.back();
    for (std::size_t i = 0; i + 1 < code.size(); ++i) lowest = model.graph.and_of(lowest, !code[i]);
    code.front() = model.graph.or_of(code.front(), lowest);
  }
  return {Number::signed_code(model.graph, code), code};
}

}  // namespace cosim::nets
