// Where everything is in the memory of a shape's lanes: planes, one a bit, lowest first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/core/value.h"

namespace cosim::lanes {

struct Layout {
  /// What a plane holds when a case begins.
  enum class First : char { no = '0', yes = '1', seed = 's', anything = 'x' };

  std::vector<First> planes;  ///< first those of the random words that the seeds of a case give
  std::size_t state = 0;      ///< the first of the model's state
  static constexpr std::size_t none = ~std::size_t{0};
  /// The RTL's flip-flops of each register, in the order of the tables; none of a bit that is no
  /// flip-flop.
  std::vector<std::vector<std::size_t>> registers;
  std::size_t counters = 0;  ///< of registers and outputs left out, as in a Run; 0: of none
};

/// Sets what a lane's registers hold, in planes of so many words, to these codes; flip-flops of no
/// register stay.
void put_registers(const Layout& layout, std::uint64_t* planes, std::size_t words, std::size_t lane,
                   const std::vector<Word>& codes);

/// In words, and from them. InputError where they are not those of a layout.
std::string to_text(const Layout& layout);
Layout parse_layout(const std::string& text);

}  // namespace cosim::lanes
