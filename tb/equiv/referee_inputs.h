// The inputs on which a netlist is compared with its source.
#pragma once

#include "tb/equiv/referee.h"
#include "tb/util/random.h"

namespace cosim::equiv {

/// Inputs by chance, in stretches of some clocks that each have their own ways: mostly low or
/// mostly high bits, small numbers, ends of ranges, what was before, the same word as another
/// input, and what the netlist compares inputs with: the cases of a decoder.
class RefereeInputs {
 public:
  using Row = std::map<std::string, std::string>;  ///< digits of each input, the highest first

  RefereeInputs(const Side& side, const Referee& how);

  /// Of one clock; they are asked for in order, from 0. Resets are active on the first three, and
  /// on one in 60 by chance.
  Row row(std::size_t clock);

 private:
  /// Bits of ports, and the digit of each.
  using Compared = std::vector<std::pair<Name, char>>;
  void find_compared();
  std::string digits(const std::string& port, std::size_t width, const Row& row);

  const Side& side_;
  const Referee& how_;
  Random random_;
  std::vector<Compared> compared_;
  std::map<std::string, std::uint64_t> ways_;
  Row before_;
};

}  // namespace cosim::equiv
