#include "tb/proof/terms.h"

#include <fmt/core.h>

namespace cosim::proof {

std::string term_of(const char* side, const Field& field) {
  return field.index < 0 ? fmt::format("{}.{}", side, field.name)
                         : fmt::format("{}.{}.{}", side, field.name, field.index);
}

std::string term_of_invariant(std::size_t i) { return fmt::format("model.kept.{}", i); }

}  // namespace cosim::proof
