// Netlists of tables, as abc writes them: the Berkeley Logic Interchange Format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cosim::nets {

/// A netlist as tables of truth.
struct Cells {
  std::string name;
  /// The nets, each of one bit, by the tool's names. All else here names a net by its number.
  std::vector<std::string> nets;
  std::vector<std::size_t> inputs, outputs;

  struct Table {
    std::vector<std::size_t> of;  ///< 0 to 6 nets
    std::uint64_t table = 0;      ///< bit i: what it gives where `of`, lowest first, are those of i
    std::size_t gives = 0;
  };
  std::vector<Table> tables;  ///< each behind all that gives what it reads
};

/// Reads one model of logic alone, without a hierarchy: .names of 6 inputs at the most. InputError,
/// which begins with `what` and says the line, of anything else, of a net that nothing drives, or
/// two things, and of a loop.
Cells read_blif(std::string_view text, const std::string& what);

}  // namespace cosim::nets
